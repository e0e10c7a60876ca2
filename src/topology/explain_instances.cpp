// SPDX-License-Identifier: Apache-2.0
#include "topology/explain_instances.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "topology/names.h"
#include "topology/text.h"

namespace hexweave {

std::vector<ExplanationStep> instances_of(const Place& place) {
    std::vector<ExplanationStep> steps;
    for (const Note* note = place.used_by.get(); note != nullptr;
         note = note->place.used_by.get()) {
        steps.push_back({note->place, note->message});
    }
    return steps;
}

std::string text_of(const JoinedPart& part) {
    return fmt::format("{} {} is {} {}{}", part.kind, quoted(part.name), part.kind,
                       quoted(part.outside), part.reversed ? ", backwards" : "");
}

std::vector<JoinedPart> parts_of_ports(const Case& written, const std::string& name) {
    std::vector<JoinedPart> parts;
    std::copy_if(written.joined.begin(), written.joined.end(), std::back_inserter(parts),
                 [&](const JoinedPart& part) { return part.name == name; });
    return parts;
}

std::vector<Explanation> explain_instances(const Case& written, const std::string& name) {
    std::vector<Explanation> all;
    const std::string prefix = name + ".";
    const auto inside = [&](const std::string& other) {
        return other.compare(0, prefix.size(), prefix) == 0;
    };
    for (const InstanceEntry& instance : written.instances) {
        if (instance.name.value != name) continue;
        Explanation explanation{"instance " + quoted(name), {}};
        auto& steps = explanation.steps;
        steps.push_back({instance.name.place,
                         fmt::format("uses component {}", quoted(instance.component.value))});
        steps.push_back({instance.component.place, "the component"});
        for (const Parameter& p : written.parameters) {
            if (!inside(p.name.value)) continue;
            steps.push_back(
                {p.name.place, fmt::format("{} = {}{}", p.name.value.substr(prefix.size()),
                                           number_text(p.value), p.overridden ? " (--set)" : "")});
        }
        for (const JoinedPart& part : written.joined) {
            if (inside(part.name)) steps.push_back({part.place, text_of(part)});
        }
        for (const ExplanationStep& step : instances_of(instance.name.place)) {
            steps.push_back(step);
        }
        all.push_back(std::move(explanation));
    }
    return all;
}

}  // namespace hexweave
