// SPDX-License-Identifier: Apache-2.0
#include "topology/yaml_end.h"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/mark.h>

#include <algorithm>
#include <cstddef>
#include <string>

#include "topology/yaml_faults.h"

namespace hexweave {

namespace {

/// Ends the parsing from inside an event.
struct DocumentFound {};

/// Notes where a document starts and goes no further.
class DocumentFinder : public YAML::EventHandler {
public:
    int start = -1;

    void OnDocumentStart(const YAML::Mark& mark) override {
        start = mark.pos;
        throw DocumentFound{};
    }
    void OnDocumentEnd() override {}
    void OnNull(const YAML::Mark& /*mark*/, YAML::anchor_t /*anchor*/) override {}
    void OnAlias(const YAML::Mark& /*mark*/, YAML::anchor_t /*anchor*/) override {}
    void OnScalar(const YAML::Mark& /*mark*/, const std::string& /*tag*/, YAML::anchor_t /*anchor*/,
                  const std::string& /*value*/) override {}
    void OnSequenceStart(const YAML::Mark& /*mark*/, const std::string& /*tag*/,
                         YAML::anchor_t /*anchor*/, YAML::EmitterStyle::value /*style*/) override {}
    void OnSequenceEnd() override {}
    void OnMapStart(const YAML::Mark& /*mark*/, const std::string& /*tag*/,
                    YAML::anchor_t /*anchor*/, YAML::EmitterStyle::value /*style*/) override {}
    void OnMapEnd() override {}
};

}  // namespace

bool check_nothing_follows(YAML::Parser& parser, const SourcePlaces& places,
                           Diagnostics& diagnostics) {
    DocumentFinder finder;
    try {
        if (!parser.HandleNextDocument(finder)) return true;
    } catch (const DocumentFound&) {
        const std::size_t start = static_cast<std::size_t>(std::max(finder.start, 0));
        diagnostics.error(places.at(start), "this does not belong to what stands before it",
                          "one file holds one mapping of keys; check the indentation");
        return false;
    } catch (const YAML::Exception& fault) {
        tell_syntax_error(fault, places, {}, diagnostics);
        return false;
    }
    return true;
}

}  // namespace hexweave
