// SPDX-License-Identifier: Apache-2.0
// `components:` and `instances:`: named parts of a topology, and where they are used. An instance
// becomes entries of the case, whose names begin with its own: "flap.wake".
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "topology/case.h"
#include "topology/instance_parameters.h"
#include "topology/read_values.h"

namespace hexweave {

/// Entities of an instance under one name, which others may be joined to.
using Ports = std::map<std::string, std::vector<Name>>;

/// A port that is the same as what stands outside of its instance. Names are qualified.
struct PortJoin {
    std::string port;  ///< "flap.inlet"
    Place place;       ///< of the word that joins it
    std::vector<Name> inside;
    std::vector<Name> outside;  ///< entities or ports
};

struct Instances {
    std::set<std::string> names;  ///< qualified
    std::vector<InstanceEntry> entries;
    std::vector<InstanceParameter> parameters;
    Ports ports;
    std::vector<PortJoin> joins;
};

/// Makes room for sections that only instances fill, so that none moves when they do.
void reserve_sections(YamlNode& root);

/// Appends the entries of all instances, and of those that they hold, to the sections of the case.
/// Told are unknown components and parameters, parameters without a value, components made of
/// themselves, unknown ports, and more entries than a case may have.
Instances expand_instances(Reading& reading, YamlNode& root);

}  // namespace hexweave
