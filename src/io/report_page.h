// SPDX-License-Identifier: Apache-2.0
// The parts of a report that are the same for every grid: the files in report_page/, built into the
// program.
#pragma once

#include <string_view>

namespace hexweave::report_page {

extern const std::string_view page_html;  ///< the page, with {{NAME}} where a grid's own parts go
extern const std::string_view style_css;
extern const std::string_view viewer_js;

}  // namespace hexweave::report_page
