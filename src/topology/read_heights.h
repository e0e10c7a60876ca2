// SPDX-License-Identifier: Apache-2.0
// The key `heights` of a face or block: sides at which first heights are held.
#pragma once

#include "topology/case.h"
#include "topology/read_values.h"

namespace hexweave {

/// `heights: {jmin: held}` or `{jmin: {height: 1e-5, fade: 0.03, growth: 1.3}}`, where `format`
/// names the sides that may stand; nothing where the key is not there.
HeightRequests read_heights(Reading& reading, const YamlNode& entry, const FormatNames& format);

}  // namespace hexweave
