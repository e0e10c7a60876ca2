// SPDX-License-Identifier: Apache-2.0
// The parameters of an instance: the command line has the last word on them, then what the instance
// sets, then what its component says.
#pragma once

#include <string>
#include <vector>

#include "topology/instance_scope.h"
#include "topology/read_values.h"

namespace hexweave {

/// A parameter of an instance, with its value there.
struct InstanceParameter {
    ScopePointer scope;
    std::string component;
    std::string name;  ///< as the component calls it
    double value = 0;
    bool overridden = false;  ///< by --set
    Place place{};            ///< in the component
};

/// Computes the parameters of an instance, called `what` in messages, in the order in which its
/// component declares them; fills its scope, and appends them. Tells those that the component has
/// not, and those that have no value.
void set_parameters(Reading& reading, const YamlNode& instance, const YamlNode& component,
                    const std::string& what, const ScopePointer& scope,
                    std::vector<InstanceParameter>& parameters);

}  // namespace hexweave
