// SPDX-License-Identifier: Apache-2.0
// How much memory this process may use.
#pragma once

#include <cstddef>
#include <string>

namespace hexweave {

/// The machine's memory in bytes or, where that is less, the limit of the process's control group
/// (containers and batch systems set one). Not what is free at the moment, so that the same case
/// passes or fails the same every time. The greatest size_t where the system does not say.
std::size_t available_memory();

/// The same, with the files of the system looked for under `root` instead of "/".
std::size_t available_memory(const std::string& root);

}  // namespace hexweave
