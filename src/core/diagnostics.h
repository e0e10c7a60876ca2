// SPDX-License-Identifier: Apache-2.0
// What is wrong with an input, and where: collected, never thrown one by one, and shown like a good
// compiler's messages.
#pragma once

#include <cstddef>
#include <exception>
#include <memory>
#include <string>
#include <vector>

namespace hexweave {

/// A text that was read: its name as the user knows it, and its contents.
struct SourceFile {
    std::string name;
    std::string text;
};

struct Note;

/// A place in a source: line and column count from 1; 0 means "the file as a whole" (line) or
/// "no column" (column). `length` is how many characters the caret underlines. Where the text there
/// is made use of from elsewhere (an included file, an instance of a component), `used_by` says so:
/// "in instance 'slat', written here", at a place that may itself be used by another.
struct Place {
    std::shared_ptr<const SourceFile> file;
    int line = 0;
    int column = 0;
    int length = 1;
    std::shared_ptr<const Note> used_by{};
};

enum class Severity { error, warning };

/// A further place that explains a diagnostic: "first defined here". As the user of a text that is
/// used several times it also says what names written there begin with where they are known to all:
/// "slat.".
struct Note {
    Place place;
    std::string message;
    std::string scope{};
};

struct Diagnostic {
    Severity severity = Severity::error;
    Place place;
    std::string message;
    std::string hint;  ///< what to do; may be empty
    std::vector<Note> notes;
};

/// The diagnostics of one run, in the order in which they were found. A file of a million lines can
/// be wrong in each: of warnings the first `most_kept` are kept and the others counted; an error
/// more than as many ends the work, as an InputError with those before it. Of a message or hint
/// longer than any of ours (it shows a text of the user's) the middle is left out. A hint says what
/// to write at its place: names are shortened to what they are there.
class Diagnostics {
public:
    static constexpr std::size_t most_kept = 200;

    Diagnostic& error(Place place, std::string message, std::string hint = {});
    Diagnostic& warning(Place place, std::string message, std::string hint = {});

    const std::vector<Diagnostic>& all() const { return all_; }
    bool has_errors() const { return errors() > 0; }
    int errors() const { return errors_.found; }
    int warnings() const { return warnings_.found; }
    /// How many were found and not kept.
    int left_out() const { return errors() + warnings() - static_cast<int>(all_.size()); }
    /// Sorted by line and column, file by file; equal messages at one place are kept once, also
    /// where they differ by the scope alone: a note then tells of the other users.
    void sort();

private:
    struct Count {
        int found = 0;
        std::size_t kept = 0;
    };

    Count& count(Severity s) { return s == Severity::error ? errors_ : warnings_; }
    Diagnostic& add(Diagnostic diagnostic);

    std::vector<Diagnostic> all_;
    Count errors_;
    Count warnings_;
    Diagnostic not_kept_;
};

/// Thrown at the end of reading and of resolving when there were errors; carries all of them.
struct InputError : std::exception {
    Diagnostics diagnostics;

    explicit InputError(Diagnostics d) : diagnostics(std::move(d)) {}
    const char* what() const noexcept override { return "the input has errors"; }
};

/// The notes as they are shown: who uses the place of the diagnostic, then its own notes, each with
/// who uses its place where that is somebody else.
std::vector<Note> all_notes(const Diagnostic& diagnostic);

/// `wing.yaml:42:9: error: ...`, the line, a caret, the notes, the hint.
std::string render(const Diagnostic& diagnostic);
std::string render(const Diagnostics& diagnostics);

/// What names written at a place begin with where they are known to all; mostly empty.
const std::string& scope_at(const Place& place);

/// The name among `known` nearest to `name` by edit distance (at most a third of its length, and
/// 3), or an empty string; also where the known names are more than 20,000.
std::string nearest_name(const std::string& name, const std::vector<std::string>& known);

}  // namespace hexweave
