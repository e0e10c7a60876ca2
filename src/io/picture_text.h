// SPDX-License-Identifier: Apache-2.0
// Text in pictures: names from any file, and numbers of an axis.
#pragma once

#include <string>

namespace hexweave {

/// The text with control characters and bytes that are not UTF-8 replaced by '?'.
std::string printable(const std::string& text);

/// The text with the characters escaped that mean something in XML.
std::string xml_escaped(const std::string& text);

/// The distance between two marks of an axis of that length with about `marks` of them: 1, 2 or 5
/// times a power of ten.
double mark_distance(double length, int marks);

/// A value on an axis with marks `step` apart: as many decimals as the step has.
std::string mark_text(double value, double step);

}  // namespace hexweave
