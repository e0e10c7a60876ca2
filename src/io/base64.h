// SPDX-License-Identifier: Apache-2.0
// Bytes as text (RFC 4648, section 4), as web pages hold them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace hexweave {

/// Four characters for every three bytes, padded with '='.
std::string to_base64(const std::vector<std::uint8_t>& bytes);

}  // namespace hexweave
