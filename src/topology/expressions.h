// SPDX-License-Identifier: Apache-2.0
// Arithmetic expressions over parameters: what may stand in a file wherever a number stands.
// Numbers, parameters, `pi` and `e`, + - * / ^, parentheses and functions; comparisons == != < <= >
// >= and && || !, whose values are 1 and 0, and `condition ? a : b`. Angles are in radians, `^` is
// the power and binds to the right. The locale does not matter.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

namespace hexweave {

/// What the expressions of a file may use.
struct ParameterScope {
    /// Parameters so far; without a value where it is faulty (and was told).
    std::map<std::string, std::optional<double>> values;
    /// Parameters that the file defines further down.
    std::set<std::string> later;
    /// Names that an expression has used.
    std::set<std::string> used;
};

/// What is wrong with an expression. `offset` and `length` tell where in its text (in bytes; what
/// is wrong is ASCII up to there). No message where a parameter without a value is the only fault.
struct ExpressionFault {
    std::string message;
    std::string hint;
    std::size_t offset = 0;
    std::size_t length = 1;
};

/// The names in a text, whether or not it is an expression.
std::vector<std::string> names_in(const std::string& text);

/// The value, always finite, or the fault.
std::variant<double, ExpressionFault> evaluate(const std::string& text, ParameterScope& scope);

/// A function of one variable, safe to call from several threads at once. Its value may be not
/// finite; only the caller knows the range.
std::variant<std::function<double(double)>, ExpressionFault> compile(const std::string& text,
                                                                     const std::string& variable,
                                                                     ParameterScope& scope);
/// The same of two variables.
std::variant<std::function<double(double, double)>, ExpressionFault> compile(
    const std::string& text, const std::array<std::string, 2>& variables, ParameterScope& scope);

/// Names that no parameter may have: the functions, `pi` and `e`.
bool is_reserved_in_expressions(const std::string& name);

}  // namespace hexweave
