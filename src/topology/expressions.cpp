// SPDX-License-Identifier: Apache-2.0
#include "topology/expressions.h"

#include <fmt/format.h>
#include <muParser.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <memory>
#include <mutex>
#include <string_view>
#include <utility>
#include <vector>

#include "topology/expression_scan.h"
#include "topology/source_text.h"

namespace hexweave {

namespace {

/// Functions that muParser lacks.
double round_down(double x) {
    return std::floor(x);
}
double round_up(double x) {
    return std::ceil(x);
}
double cube_root(double x) {
    return std::cbrt(x);
}
double negated(double x) {
    return x == 0 ? 1 : 0;
}

/// The values of at most two variables.
using Arguments = std::array<double, 2>;

/// A parser and the variables that its text may use; not to be moved, for muParser keeps the
/// variables' addresses, and not to be used by two threads at once.
class CompiledText {
public:
    CompiledText(const std::string& text, const std::vector<std::string>& variables,
                 const std::map<std::string, double>& values) {
        parser_.ClearConst();
        parser_.EnableOptimizer(false);
        parser_.DefineFun("floor", round_down);
        parser_.DefineFun("ceil", round_up);
        parser_.DefineFun("cbrt", cube_root);
        parser_.DefineInfixOprt("!", negated, mu::prINFIX);
        for (const auto& [name, value] : values) parser_.DefineConst(name, value);
        for (std::size_t n = 0; n < variables.size(); ++n) {
            parser_.DefineVar(variables[n], &arguments_.at(n));
        }
        parser_.SetExpr(text);
    }
    CompiledText(const CompiledText&) = delete;
    CompiledText& operator=(const CompiledText&) = delete;
    CompiledText(CompiledText&&) = delete;
    CompiledText& operator=(CompiledText&&) = delete;
    ~CompiledText() = default;

    double operator()(const Arguments& arguments) {
        arguments_ = arguments;
        return parser_.Eval();
    }

private:
    mu::Parser parser_;
    Arguments arguments_{};
};

constexpr const char* arguments_hint =
    "min and max have one or more, atan2(y, x) has two, every other function one";

ExpressionFault fault_of(const mu::ParserError& error, const std::string& text) {
    ExpressionFault fault;
    const std::size_t last = text.empty() ? 0 : text.size() - 1;
    fault.offset =
        error.GetPos() < 0 ? last : std::min(static_cast<std::size_t>(error.GetPos()), text.size());
    const std::string& token = error.GetToken();
    switch (error.GetCode()) {
        case mu::ecUNEXPECTED_EOF:
        case mu::ecEMPTY_EXPRESSION:
            fault.message = "the expression ends too early";
            fault.hint = "a value is lacking behind the last operator or parenthesis";
            fault.offset = text.size();
            break;
        case mu::ecMISSING_PARENS:
            fault.message = "a ')' is missing";
            fault.hint = "close every parenthesis";
            break;
        case mu::ecUNEXPECTED_PARENS:
            fault.message = "a parenthesis where none can stand";
            fault.hint = "every ')' closes a '('";
            break;
        case mu::ecUNEXPECTED_OPERATOR:
        case mu::ecUNASSIGNABLE_TOKEN:
            fault.message = "an operator where a value should stand";
            fault.hint = "write a value on both sides of it";
            break;
        case mu::ecMISPLACED_COLON:
            fault.message = "a ':' without a '?' before it";
            fault.hint = "a choice is written condition ? a : b";
            break;
        case mu::ecMISSING_ELSE_CLAUSE:
            fault.message = "a '?' without its ':'";
            fault.hint = "a choice is written condition ? a : b";
            break;
        case mu::ecTOO_MANY_PARAMS:
            fault.message = "too many arguments";
            fault.hint = arguments_hint;
            break;
        case mu::ecTOO_FEW_PARAMS:
            fault.message = "too few arguments";
            fault.hint = arguments_hint;
            break;
        case mu::ecEXPRESSION_TOO_LONG:
            fault.message = "the expression is too long";
            fault.hint = "name parts of it under 'parameters'";
            break;
        case mu::ecIDENTIFIER_TOO_LONG:
            fault.message = "a name in the expression is too long";
            break;
        default:
            fault.message = token.empty() ? "this is not an arithmetic expression"
                                          : fmt::format("unexpected '{}'", shown(token));
    }
    return fault;
}

/// Compiled copies of one text, as many as threads have ever asked at once.
class CopiesForThreads {
public:
    CopiesForThreads(std::string text, std::vector<std::string> variables,
                     std::map<std::string, double> values)
        : text_(std::move(text)), variables_(std::move(variables)), values_(std::move(values)) {}

    double operator()(const Arguments& arguments) {
        std::unique_ptr<CompiledText> mine = take();
        const double value = (*mine)(arguments);
        const std::lock_guard lock(mutex_);
        idle_.push_back(std::move(mine));
        return value;
    }

private:
    std::unique_ptr<CompiledText> take() {
        {
            const std::lock_guard lock(mutex_);
            if (!idle_.empty()) {
                std::unique_ptr<CompiledText> mine = std::move(idle_.back());
                idle_.pop_back();
                return mine;
            }
        }
        return std::make_unique<CompiledText>(text_, variables_, values_);
    }

    std::string text_;
    std::vector<std::string> variables_;
    std::map<std::string, double> values_;
    std::mutex mutex_;
    std::vector<std::unique_ptr<CompiledText>> idle_;
};

/// A number as it stands, by far the most frequent expression.
std::optional<double> plain_number(const std::string& text) {
    double value = 0;
    const bool negative = !text.empty() && text.front() == '-';
    const char* const begin = text.data() + (negative ? 1 : 0);
    const char* const end = text.data() + text.size();
    if (begin == end || *begin < '0' || *begin > '9') return std::nullopt;
    const auto [stop, error] = std::from_chars(begin, end, value);
    if (error != std::errc() || stop != end) return std::nullopt;
    return negative ? -value : value;
}

/// A function of the values of `variables`.
std::variant<std::shared_ptr<CopiesForThreads>, ExpressionFault> compile_copies(
    const std::string& text, const std::vector<std::string>& variables, ParameterScope& scope) {
    for (const std::string& variable : variables) {
        if (!scope.values.contains(variable)) continue;
        return ExpressionFault{
            fmt::format("'{}' is the variable of a formula, and a parameter has the same name",
                        variable),
            "rename the parameter", 0, text.size()};
    }
    ScannedExpression scan = scan_expression(text, variables, scope);
    if (scan.fault) return std::move(*scan.fault);
    if (scan.lacks_value) return ExpressionFault{};
    auto copies = std::make_shared<CopiesForThreads>(text, variables, std::move(scan.values));
    try {
        (*copies)({0.5, 0.5});
    } catch (const mu::ParserError& error) {
        return fault_of(error, text);
    }
    return copies;
}

/// With which values an expression was computed.
std::string values_hint(const std::map<std::string, double>& values) {
    std::string text;
    for (const auto& [name, value] : values) {
        if (constant_value(name)) continue;
        text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", name, value);
    }
    return text.empty()
               ? "divisions by zero, roots and logarithms of negative numbers have no value"
               : "with " + text;
}

}  // namespace

std::vector<std::string> names_in(const std::string& text) {
    static constexpr std::string_view letters =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_0123456789";
    std::vector<std::string> names;
    for (std::size_t begin = text.find_first_of(letters); begin != std::string::npos;) {
        const std::size_t end = std::min(text.find_first_not_of(letters, begin), text.size());
        names.push_back(text.substr(begin, end - begin));
        begin = text.find_first_of(letters, end);
    }
    return names;
}

std::variant<double, ExpressionFault> evaluate(const std::string& text, ParameterScope& scope) {
    if (const std::optional<double> number = plain_number(text)) return *number;
    ScannedExpression scan = scan_expression(text, {}, scope);
    if (scan.fault) return std::move(*scan.fault);
    if (scan.lacks_value) return ExpressionFault{};
    double value = 0;
    try {
        value = CompiledText(text, {}, scan.values)({});
    } catch (const mu::ParserError& error) {
        return fault_of(error, text);
    }
    if (!std::isfinite(value)) {
        return ExpressionFault{
            fmt::format("'{}' is not finite: its value is {}", shown(text),
                        std::isnan(value) ? "not a number" : fmt::format("{}", value)),
            values_hint(scan.values), 0, text.size()};
    }
    return value;
}

std::variant<std::function<double(double)>, ExpressionFault> compile(const std::string& text,
                                                                     const std::string& variable,
                                                                     ParameterScope& scope) {
    auto result = compile_copies(text, {variable}, scope);
    if (auto* fault = std::get_if<ExpressionFault>(&result)) return std::move(*fault);
    const auto copies = std::get<std::shared_ptr<CopiesForThreads>>(result);
    return [copies](double argument) { return (*copies)({argument, 0}); };
}

std::variant<std::function<double(double, double)>, ExpressionFault> compile(
    const std::string& text, const std::array<std::string, 2>& variables, ParameterScope& scope) {
    auto result = compile_copies(text, {variables[0], variables[1]}, scope);
    if (auto* fault = std::get_if<ExpressionFault>(&result)) return std::move(*fault);
    const auto copies = std::get<std::shared_ptr<CopiesForThreads>>(result);
    return [copies](double first, double second) { return (*copies)({first, second}); };
}

bool is_reserved_in_expressions(const std::string& name) {
    return is_function_name(name) || constant_value(name).has_value() || name == "log";
}

}  // namespace hexweave
