// SPDX-License-Identifier: Apache-2.0
// A look through an expression before muParser parses it: refuses what users are not promised
// (muParser also knows assignments, strings and lists) and collects the names.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "topology/expressions.h"

namespace hexweave {

struct ScannedExpression {
    std::optional<ExpressionFault> fault;
    std::map<std::string, double> values;  ///< of the parameters and constants that occur
    bool lacks_value = false;              ///< a parameter occurs whose own value is faulty
};

/// Marks the parameters that occur as used. `variables` are names that have no value yet.
ScannedExpression scan_expression(const std::string& text,
                                  const std::vector<std::string>& variables, ParameterScope& scope);

bool is_function_name(std::string_view name);
/// The value of `pi` or `e`.
std::optional<double> constant_value(std::string_view name);

}  // namespace hexweave
