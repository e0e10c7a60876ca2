// SPDX-License-Identifier: Apache-2.0
// A grid as one page to look at: what `hexweave report` writes (docs/report.md). It stands alone:
// it opens from the disk, with no network.
#pragma once

#include <string>
#include <vector>

#include "core/multiblock.h"
#include "io/picture.h"
#include "io/report_sheets.h"
#include "quality/grid_quality.h"

namespace hexweave {

struct HtmlReportOptions {
    std::string grid_file;           ///< as the page calls it
    std::vector<IndexPlane> planes;  ///< to have besides those chosen
    std::string run = "null";        ///< the JSON of RunOfGrid
    SheetBudget budget;
};

/// The page. Throws UsageError for a plane that the grid does not have.
std::string html_report(const MultiblockGrid& grid, const GridQuality& quality,
                        const HtmlReportOptions& options);

}  // namespace hexweave
