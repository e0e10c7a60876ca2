// SPDX-License-Identifier: Apache-2.0
// The `parameters:` of a file.
#pragma once

#include <vector>

#include "topology/instance_parameters.h"
#include "topology/read_values.h"

namespace hexweave {

/// Evaluates the parameters in order, an overridden one by its override, and fills the scope for
/// the expressions that follow. `section` may be null.
std::vector<Parameter> read_parameters(Reading& reading, const YamlNode* section);

/// Tells a name that no parameter may have.
void check_parameter_name(Reading& reading, const YamlNode& node);

/// Warns of parameters of the case, and of its components, that nothing used, unless they were
/// overridden.
void warn_unused_parameters(Reading& reading, const std::vector<Parameter>& parameters,
                            const std::vector<InstanceParameter>& of_instances);

}  // namespace hexweave
