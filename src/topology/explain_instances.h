// SPDX-License-Identifier: Apache-2.0
// What `--explain` tells of instances of components, and of the parts of their ports.
#pragma once

#include <string>
#include <vector>

#include "topology/explain.h"

namespace hexweave {

/// Where the instances are that an entry of a component comes from, the innermost first.
std::vector<ExplanationStep> instances_of(const Place& place);

/// An instance of this name: its component, the values of its parameters, what its ports became.
std::vector<Explanation> explain_instances(const Case& written, const std::string& name);

/// The parts of ports that had this name, with what they are now.
std::vector<JoinedPart> parts_of_ports(const Case& written, const std::string& name);

/// "edge 'b.west' is edge 'a.east', backwards"
std::string text_of(const JoinedPart& part);

}  // namespace hexweave
