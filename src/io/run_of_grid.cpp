// SPDX-License-Identifier: Apache-2.0
#include "io/run_of_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "core/errors.h"
#include "io/json_values.h"

namespace hexweave {
namespace {

std::string size_text(const Json& nodes) {
    std::vector<std::string> counts;
    for (const Json& n : nodes) counts.push_back(n.dump());
    return fmt::format("{} nodes", fmt::join(counts, " x "));
}

/// What is amiss with a run's report as that of a grid; empty where it is that.
std::string difference(const Json& report, const MultiblockGrid& grid) {
    const Json zones = report.value("zones", Json::array());
    for (const Zone& zone : grid.zones) {
        const auto same = std::find_if(zones.begin(), zones.end(), [&](const Json& other) {
            return other.value("name", "") == zone.name;
        });
        if (same == zones.end()) return fmt::format("it has no zone '{}'", zone.name);
        const Json own = json_of(zone.points.extent());
        const Json other = same->value("nodes", Json::array());
        if (other != own) {
            return fmt::format("zone '{}' has {} there, {} in the grid", zone.name,
                               size_text(other), size_text(own));
        }
    }
    if (zones.size() == grid.zones.size()) return {};
    return fmt::format("it has {} zones, the grid {}", zones.size(), grid.zones.size());
}

}  // namespace

RunOfGrid run_of_grid(const std::string& text, const std::string& path,
                      const MultiblockGrid& grid) {
    const auto refuse = [&path](const std::string& reason) {
        throw UsageError(fmt::format("--run {}: {}", path, reason));
    };
    const Json run = Json::parse(text, nullptr, false);
    if (!run.is_object() || !run.contains("hexweave_json") || run.value("command", "") != "run" ||
        !run.contains("report")) {
        refuse("the file is not what 'hexweave run --json' writes");
    }
    if (!run["report"].is_object()) refuse("that run made no grid");
    std::vector<Json> reports{run["report"]};
    for (const Json& level : run.value("levels", Json::array())) reports.push_back(level);
    const auto own = std::find_if(reports.begin(), reports.end(), [&grid](const Json& report) {
        return difference(report, grid).empty();
    });
    if (own == reports.end()) {
        refuse("that run made another grid: " + difference(reports.front(), grid));
    }
    Json shown{{"config", run.value("config", "")},
               {"parameters", run.value("parameters", Json::array())}};
    for (const char* key : {"gates", "solves", "spacings"}) {
        shown[key] = own->value(key, Json::array());
    }
    const auto missed = std::count_if(shown["gates"].begin(), shown["gates"].end(),
                                      [](const Json& gate) { return !gate.value("met", true); });
    return {shown.dump(), static_cast<std::size_t>(missed)};
}

}  // namespace hexweave
