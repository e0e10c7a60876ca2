// SPDX-License-Identifier: Apache-2.0
// What must hold whatever stands in a config: it is read and resolved to a topology that keeps its
// promises, or refused with messages that a user can read. Shared by the fuzzer and by the test
// that runs over what the fuzzer has found.
#pragma once

#include <string>

namespace hexweave::testing {

/// Reads, resolves and explains a text as `hexweave check --explain` does, at every level of its
/// family. Empty, or the first thing that does not hold. The files that it names are looked for
/// beside tests/cases/examples; nothing is written.
std::string broken_rule(const std::string& text);

}  // namespace hexweave::testing
