// SPDX-License-Identifier: Apache-2.0
// Runs the program as a user does: in a folder of its own, through a shell, keeping what it
// printed.
#pragma once

#include <filesystem>
#include <string>

namespace hexweave::testing {

struct Finished {
    int exit_code = 0;  ///< 128 + signal where a signal ended it, as shells say
    std::string out;
    std::string err;
};

/// An empty folder that is removed at the end of the test.
class Scratch {
public:
    Scratch();
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
    ~Scratch();

    const std::filesystem::path& path() const { return path_; }
    /// Runs `hexweave ARGUMENTS` (shell syntax) in this folder.
    Finished hexweave(const std::string& arguments) const;
    /// Runs any shell command in this folder.
    Finished shell(const std::string& command) const;
    /// Writes a text file and returns its name.
    std::string write(const std::string& name, const std::string& text) const;
    bool has(const std::string& name) const { return std::filesystem::exists(path_ / name); }
    std::string read(const std::string& name) const;
    /// The names of everything in the folder, hidden files too, sorted, joined by spaces.
    std::string listing() const;

private:
    std::filesystem::path path_;
};

/// The whole of a file, as bytes.
std::string slurp(const std::filesystem::path& path);

/// A file of configs/.
std::string shipped(const std::string& name);

/// The text of a shipped config with more of it after the first place where `after` stands.
std::string shipped_with(const std::string& name, const std::string& after,
                         const std::string& more);

bool contains(const std::string& text, const std::string& part);

/// Options that make the grid of `vane_annulus.yaml` small.
inline const std::string small_annulus =
    " --set span_cells=6 --set ring_cells=20 --set front_cells=12 --set side_cells=20 "
    "--set rear_cells=14 --set gap_cells=8 --set inlet_cells=10 --set outlet_cells=16";

/// A square of 4 x 3 cells.
inline const std::string tiny = R"(hexweave: 1
vertices: {a: [0, 0], b: [1, 0], c: [1, 1], d: [0, 1]}
edges:
  south: {from: a, to: b, cells: 4}
  west: {from: a, to: d, cells: 3}
faces:
  square: {corners: [a, b, c, d]}
boundaries:
  rim: {type: BCWall, sides: [south, west, b-c, c-d]}
)";

/// A face whose north side comes to its last vertex from within, but whose last point before that
/// vertex lies outside: the boundary alone folds a cell, and no grid is sound.
inline const std::string folded_by_its_boundary = R"(hexweave: 1
units: m
curves:
  hook: {polyline: [[0, 1], [0.6, 1], [1.3, 1.3], [0.98, 1.02], [1, 1]]}
vertices: {a: [0, 0], b: [1, 0.3], c: [1, 1], d: [0, 1]}
edges:
  south: {from: a, to: b, cells: 8}
  north: {from: d, to: c, along: hook, spacing: {positions: [0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.75, 1]}}
  west: {from: a, to: d, cells: 6}
  east: {from: b, to: c}
faces:
  tie: {imin: west, imax: east, jmin: south, jmax: north}
boundaries:
  rim: {type: BCWall, sides: [south, west, east, north]}
)";

}  // namespace hexweave::testing
