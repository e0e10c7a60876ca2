// SPDX-License-Identifier: Apache-2.0
#include "io/output_files.h"

#include <sys/stat.h>

#include <catch2/catch.hpp>

#include "core/errors.h"
#include "io/scratch.h"

using namespace hexweave;
using Names = std::vector<std::string>;
namespace fs = std::filesystem;

TEST_CASE("A staged file appears under its name when it is committed, not before") {
    const Scratch scratch;
    OutputFiles files;
    const fs::path temporary = files.stage(scratch.path("wing.cgns"));
    CHECK(temporary.parent_path() == fs::canonical(scratch.folder()));
    CHECK(temporary.filename() == ".wing.cgns.tmp." + std::to_string(getpid()));
    put(temporary, "grid");
    CHECK_FALSE(fs::exists(scratch.path("wing.cgns")));
    files.commit();
    CHECK(contents(scratch.path("wing.cgns")) == "grid");
    CHECK(scratch.names() == Names{"wing.cgns"});
}

TEST_CASE("What is not committed leaves the former file and nothing else") {
    const Scratch scratch;
    put(scratch.path("a"), "former");
    {
        OutputFiles files;
        put(files.stage(scratch.path("a")), "new");
        put(files.stage(scratch.path("b")), "new");
    }
    CHECK(contents(scratch.path("a")) == "former");
    CHECK(scratch.names() == Names{"a"});
}

TEST_CASE("Several files are replaced together, and keep their permissions") {
    const Scratch scratch;
    put(scratch.path("a"), "former");
    fs::permissions(scratch.path("a"), fs::perms(0640));
    OutputFiles files;
    put(files.stage(scratch.path("a")), "new a");
    put(files.stage(scratch.path("b")), "new b");
    files.commit();
    CHECK(contents(scratch.path("a")) == "new a");
    CHECK(contents(scratch.path("b")) == "new b");
    CHECK(fs::status(scratch.path("a")).permissions() == fs::perms(0640));
    CHECK(scratch.names() == Names{"a", "b"});
}

TEST_CASE("When one file cannot be put in place none is") {
    const Scratch scratch;
    put(scratch.path("a"), "former");
    {
        OutputFiles files;
        put(files.stage(scratch.path("a")), "new a");
        put(files.stage(scratch.path("b")), "new b");
        put(files.stage(scratch.path("c")), "new c");
        fs::create_directory(scratch.path("c"));
        CHECK_THROWS_WITH(files.commit(),
                          "cannot write '" + scratch.path("c").string() + "': is a directory");
    }
    CHECK(contents(scratch.path("a")) == "former");
    CHECK(scratch.names() == Names{"a", "c"});
}

TEST_CASE("A temporary file that has gone missing changes nothing") {
    const Scratch scratch;
    put(scratch.path("a"), "former");
    OutputFiles files;
    put(files.stage(scratch.path("a")), "new a");
    fs::remove(files.stage(scratch.path("b")));
    CHECK_THROWS_AS(files.commit(), MachineError);
    CHECK(contents(scratch.path("a")) == "former");
}

TEST_CASE("A link stays, and the file that it points to is replaced") {
    const Scratch scratch;
    fs::create_directory(scratch.path("store"));
    put(scratch.path("store/real"), "former");
    fs::create_symlink("store/real", scratch.path("near"));
    fs::create_symlink("near", scratch.path("far"));
    fs::create_symlink("store/later", scratch.path("dangling"));
    OutputFiles files;
    put(files.stage(scratch.path("far")), "new");
    put(files.stage(scratch.path("dangling")), "first");
    files.commit();
    CHECK(fs::is_symlink(scratch.path("far")));
    CHECK(fs::is_symlink(scratch.path("near")));
    CHECK(contents(scratch.path("store/real")) == "new");
    CHECK(contents(scratch.path("store/later")) == "first");
    CHECK(scratch.names() == Names{"dangling", "far", "near", "store"});
}

TEST_CASE("What cannot be written is told before anything is made") {
    const Scratch scratch;
    const std::string folder = scratch.folder().string();
    put(scratch.path("file"), "former");
    fs::create_symlink("loop", scratch.path("loop"));
    OutputFiles files;
    const auto reason = [&](const std::string& path) {
        try {
            files.stage(path);
        } catch (const UsageError& error) {
            const std::string text = error.what();
            const std::string start = "cannot write '" + path + "': ";
            CHECK(text.substr(0, start.size()) == start);
            return text.substr(start.size());
        }
        return std::string("staged");
    };
    CHECK(reason(folder + "/out/wing.cgns") == "no such folder '" + folder + "/out'");
    CHECK(reason(folder) == "it is a folder");
    CHECK(reason(folder + "/") == "it is a folder");
    CHECK(reason(folder + "/file/wing.cgns") == "'" + folder + "/file' is not a folder");
    CHECK(reason(folder + "/file/out/wing.cgns") == "'" + folder + "/file/out' is not a folder");
    CHECK(reason(folder + "/loop") == "too many levels of symbolic links");
    CHECK(reason(folder + "/" + std::string(300, 'x')) == "file name too long");
    CHECK(reason("/dev/null") == "it is not a regular file");
    CHECK_THROWS_AS(files.stage("/proc/wing.cgns"), MachineError);
    CHECK(reason("") == "it names no file");
    CHECK(scratch.names() == Names{"file", "loop"});
}

TEST_CASE("A folder or a file without permission is not written") {
    if (geteuid() == 0) {
        WARN("skipped: the superuser may write everywhere");
        return;
    }
    const Scratch scratch;
    put(scratch.path("protected"), "former");
    fs::permissions(scratch.path("protected"), fs::perms(0444));
    fs::create_directory(scratch.path("closed"));
    fs::permissions(scratch.path("closed"), fs::perms(0555));
    OutputFiles files;
    CHECK_THROWS_WITH(files.stage(scratch.path("protected")),
                      Catch::Matchers::EndsWith("permission denied"));
    CHECK_THROWS_WITH(files.stage(scratch.path("closed/a")),
                      Catch::Matchers::EndsWith("closed/a': permission denied"));
}

TEST_CASE("A file can be staged once, under whatever name") {
    const Scratch scratch;
    fs::create_symlink("a", scratch.path("also_a"));
    OutputFiles files;
    files.stage(scratch.path("a"));
    CHECK_THROWS_AS(files.stage(scratch.path("a")), UsageError);
    CHECK_THROWS_AS(files.stage(scratch.path("also_a")), UsageError);
}

TEST_CASE("The temporary file of a killed process is left alone") {
    const Scratch scratch;
    const std::string stale = ".a.tmp." + std::to_string(getpid());
    put(scratch.path(stale), "of another");
    {
        OutputFiles files;
        put(files.stage(scratch.path("a")), "new");
        files.commit();
    }
    CHECK(contents(scratch.path("a")) == "new");
    CHECK(contents(scratch.path(stale)) == "of another");
}

TEST_CASE("The longest name that a file system allows can be written") {
    const Scratch scratch;
    const std::string name(255, 'n');
    OutputFiles files;
    put(files.stage(scratch.path(name)), "new");
    files.commit();
    CHECK(scratch.names() == Names{name});
}

TEST_CASE("Hundreds of files can be staged at once") {
    const Scratch scratch;
    OutputFiles files;
    for (int n = 0; n < 300; ++n) put(files.stage(scratch.path(std::to_string(n))), "grid");
    CHECK(scratch.names().size() == 300);
    files.commit();
    CHECK(contents(scratch.path("299")) == "grid");
    CHECK(scratch.names().size() == 300);
}

TEST_CASE("A folder that was made stays with its files, and goes without them") {
    const Scratch scratch;
    for (const bool commits : {false, true}) {
        {
            OutputFiles files;
            files.make_folder(scratch.path("case"));
            files.make_folder(scratch.path("case") / "inner");
            put(files.stage(scratch.path("case") / "inner" / "grid"), "grid");
            if (commits) files.commit();
        }
        CHECK(fs::exists(scratch.path("case")) == commits);
    }
    CHECK(contents(scratch.path("case") / "inner" / "grid") == "grid");
    {
        OutputFiles files;
        files.make_folder(scratch.path("case"));  // not ours: it was there
        put(files.stage(scratch.path("case") / "other"), "grid");
    }
    CHECK(scratch.names() == Names{"case"});
    put(scratch.path("file"), "");
    OutputFiles files;
    CHECK_THROWS_AS(files.make_folder(scratch.path("file")), UsageError);
    CHECK_THROWS_AS(files.make_folder(scratch.path("none") / "inner"), UsageError);
}
