// SPDX-License-Identifier: Apache-2.0
#include "tests/commands/program.h"

#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <vector>

namespace hexweave::testing {

namespace fs = std::filesystem;

std::string slurp(const fs::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

std::string shipped(const std::string& name) {
    return std::string(HEXWEAVE_SOURCE_DIR) + "/configs/" + name;
}

Scratch::Scratch() {
    std::string name = (fs::temp_directory_path() / "hexweave-test-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no scratch folder");
    path_ = name;
}

Scratch::~Scratch() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

Finished Scratch::hexweave(const std::string& arguments) const {
    return shell(std::string("'") + HEXWEAVE_PROGRAM + "' " + arguments);
}

Finished Scratch::shell(const std::string& command) const {
    // What the command prints is kept beside the folder, so that the folder's listing stays clean.
    const fs::path out = path_.string() + ".out";
    const fs::path err = path_.string() + ".err";
    const std::string whole = "cd '" + path_.string() + "' && { " + command + "\n} >'" +
                              out.string() + "' 2>'" + err.string() + "'";
    const int status = std::system(whole.c_str());
    Finished finished{WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), slurp(out),
                      slurp(err)};
    fs::remove(out);
    fs::remove(err);
    return finished;
}

std::string Scratch::write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
    return name;
}

std::string Scratch::read(const std::string& name) const {
    return slurp(path_ / name);
}

std::string Scratch::listing() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(path_)) {
        names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    std::string joined;
    for (const std::string& name : names) joined += (joined.empty() ? "" : " ") + name;
    return joined;
}

std::string shipped_with(const std::string& name, const std::string& after,
                         const std::string& more) {
    std::string text = slurp(shipped(name));
    const std::size_t at = text.find(after);
    if (at == std::string::npos) throw std::runtime_error(name + " has no '" + after + "'");
    return text.insert(at + after.size(), more);
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace hexweave::testing
