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
#include <numbers>
#include <string_view>
#include <utility>

#include "core/diagnostics.h"

namespace hexweave {

namespace {

struct Function {
    std::string_view name;
    int arguments;  ///< -1: one or more
};

/// muParser defines more; what is not listed here does not exist for users.
constexpr std::array<Function, 25> functions{
    {{"sin", 1},   {"cos", 1},   {"tan", 1},   {"asin", 1}, {"acos", 1},
     {"atan", 1},  {"atan2", 2}, {"sinh", 1},  {"cosh", 1}, {"tanh", 1},
     {"asinh", 1}, {"acosh", 1}, {"atanh", 1}, {"exp", 1},  {"ln", 1},
     {"log2", 1},  {"log10", 1}, {"sqrt", 1},  {"cbrt", 1}, {"abs", 1},
     {"sign", 1},  {"floor", 1}, {"ceil", 1},  {"min", -1}, {"max", -1}}};

constexpr std::array<std::pair<std::string_view, double>, 2> constants{
    {{"pi", std::numbers::pi}, {"e", std::numbers::e}}};

bool is_function(std::string_view name) {
    return std::any_of(functions.begin(), functions.end(),
                       [&](const Function& f) { return f.name == name; });
}

std::optional<double> constant(std::string_view name) {
    const auto* found = std::find_if(constants.begin(), constants.end(),
                                     [&](const auto& c) { return c.first == name; });
    return found == constants.end() ? std::nullopt : std::optional(found->second);
}

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}
bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\n';
}

/// Goes once through an expression before muParser does: refuses what is not arithmetic (muParser
/// also knows assignments, strings, comparisons and lists) and collects the names.
class Scan {
public:
    Scan(const std::string& text, const std::string& variable, ParameterScope& scope)
        : text_(text), variable_(variable), scope_(scope) {}

    /// The values of the names that occur.
    std::map<std::string, double> values;
    bool has_unknown_value = false;

    std::optional<ExpressionFault> run() {
        std::optional<ExpressionFault> fault;
        while (at_ < text_.size() && !fault) fault = next();
        return fault;
    }

private:
    std::optional<ExpressionFault> next() {
        const char c = text_[at_];
        if (is_letter(c)) return name();
        if (is_digit(c) || c == '.') return number();
        if (c == '(') calls_.push_back(after_function_);
        if (c == ')' && !calls_.empty()) calls_.pop_back();
        if (c == ',' && (calls_.empty() || !calls_.back())) {
            return ExpressionFault{"a ',' where none can stand",
                                   "the decimal separator is the point", at_, 1};
        }
        if (c == '*' && text_.compare(at_, 2, "**") == 0) {
            return ExpressionFault{"'**' is not an operator", "the power is written '^'", at_, 2};
        }
        if (!is_blank(c) && std::string_view("+-*/^(),").find(c) == std::string_view::npos) {
            return foreign_character();
        }
        if (!is_blank(c)) after_function_ = false;
        after_value_ = c == ')' || (is_blank(c) && after_value_);
        ++at_;
        return std::nullopt;
    }

    ExpressionFault foreign_character() const {
        std::size_t bytes = 1;
        while (at_ + bytes < text_.size() && (text_[at_ + bytes] & 0xC0) == 0x80) ++bytes;
        return {fmt::format("'{}' has no place in an expression", text_.substr(at_, bytes)),
                "expressions have numbers, parameters, + - * / ^ ( ) and functions", at_, 1};
    }

    std::optional<ExpressionFault> number() {
        double value = 0;
        const char* const begin = text_.data() + at_;
        const char* const end = text_.data() + text_.size();
        const auto [stop, error] = std::from_chars(begin, end, value);
        const auto length = std::max<std::size_t>(1, static_cast<std::size_t>(stop - begin));
        const std::string written = text_.substr(at_, length);
        if (error == std::errc::invalid_argument)
            return ExpressionFault{"a '.' without digits", {}, at_, 1};
        if (error != std::errc()) {
            return ExpressionFault{
                fmt::format("the number {} is out of range", written), {}, at_, length};
        }
        const bool glued = stop != end && (is_letter(*stop) || is_digit(*stop) || *stop == '.');
        if (glued) return bad_number();
        if (after_value_) return operator_missing(written, length);
        at_ += length;
        after_value_ = true;
        return std::nullopt;
    }

    ExpressionFault bad_number() const {
        std::size_t end = at_;
        while (end < text_.size() &&
               (is_letter(text_[end]) || is_digit(text_[end]) || text_[end] == '.')) {
            ++end;
        }
        const std::string written = text_.substr(at_, end - at_);
        return {fmt::format("'{}' is neither a number nor a name", written),
                "write '*' between a number and a name", at_, end - at_};
    }

    ExpressionFault operator_missing(const std::string& written, std::size_t length) const {
        return {fmt::format("an operator is missing before '{}'", written), {}, at_, length};
    }

    std::optional<ExpressionFault> name() {
        std::size_t end = at_;
        while (end < text_.size() && (is_letter(text_[end]) || is_digit(text_[end]))) ++end;
        const std::string name = text_.substr(at_, end - at_);
        const std::size_t after = text_.find_first_not_of(" \t\n", end);
        const bool called = after != std::string::npos && text_[after] == '(';
        if (after_value_) return operator_missing(name, name.size());

        after_function_ = called;
        after_value_ = !called;
        std::optional<ExpressionFault> fault = called ? function(name) : value(name);
        at_ = end;
        return fault;
    }

    std::optional<ExpressionFault> function(const std::string& name) const {
        if (is_function(name)) return std::nullopt;
        ExpressionFault fault{fmt::format("there is no function '{}'", name), {}, at_, name.size()};
        std::vector<std::string> known;
        for (const Function& f : functions) known.emplace_back(f.name);
        const std::string nearest = nearest_name(name, known);
        if (name == "log") {
            fault.hint = "write 'ln' for the natural logarithm, 'log10' for that of base 10";
        } else if (scope_.values.contains(name) || name == variable_ || constant(name)) {
            fault.message = fmt::format("an operator is missing between '{}' and '('", name);
        } else if (!nearest.empty()) {
            fault.hint = fmt::format("did you mean '{}'?", nearest);
        } else {
            fault.hint = "functions are " + fmt::format("{}", fmt::join(known, ", "));
        }
        return fault;
    }

    std::optional<ExpressionFault> value(const std::string& name) {
        if (name == variable_) return std::nullopt;
        if (const std::optional<double> known = constant(name)) {
            values[name] = *known;
            return std::nullopt;
        }
        const auto found = scope_.values.find(name);
        if (found == scope_.values.end()) return unknown(name);
        scope_.used.insert(name);
        if (found->second) {
            values[name] = *found->second;
        } else {
            has_unknown_value = true;
        }
        return std::nullopt;
    }

    ExpressionFault unknown(const std::string& name) const {
        ExpressionFault fault{fmt::format("unknown parameter '{}'", name), {}, at_, name.size()};
        std::vector<std::string> known;
        for (const auto& [parameter, value] : scope_.values) known.push_back(parameter);
        const std::string nearest = nearest_name(name, known);
        if (scope_.later.contains(name)) {
            fault.message = fmt::format("the parameter '{}' is used before it is defined", name);
            fault.hint = "parameters may use only those that stand before them";
        } else if (is_function(name)) {
            fault.message =
                fmt::format("the function '{}' lacks its argument in parentheses", name);
        } else if (!nearest.empty()) {
            fault.hint = fmt::format("did you mean '{}'?", nearest);
        } else if (!known.empty() && known.size() <= 20) {
            fault.hint = fmt::format("known parameters are {}", fmt::join(known, ", "));
        }
        return fault;
    }

    const std::string& text_;
    const std::string& variable_;
    ParameterScope& scope_;
    std::size_t at_ = 0;
    std::vector<bool> calls_;  ///< open parentheses: whether each holds a function's arguments
    bool after_function_ = false;
    bool after_value_ = false;  ///< a number, a name or a ')' has just ended
};

/// muParser's rounding functions differ from what their names promise elsewhere; the sign of zero
/// and the like are those of the C library.
double round_down(double x) {
    return std::floor(x);
}
double round_up(double x) {
    return std::ceil(x);
}
double cube_root(double x) {
    return std::cbrt(x);
}

/// A parser and the one variable that its text may use; not to be moved, for muParser keeps the
/// variable's address, and not to be used by two threads at once.
class CompiledText {
public:
    CompiledText(const std::string& text, const std::string& variable,
                 const std::map<std::string, double>& values) {
        parser_.ClearConst();
        parser_.EnableOptimizer(false);
        parser_.DefineFun("floor", round_down);
        parser_.DefineFun("ceil", round_up);
        parser_.DefineFun("cbrt", cube_root);
        for (const auto& [name, value] : values) parser_.DefineConst(name, value);
        if (!variable.empty()) parser_.DefineVar(variable, &variable_);
        parser_.SetExpr(text);
    }
    CompiledText(const CompiledText&) = delete;
    CompiledText& operator=(const CompiledText&) = delete;
    CompiledText(CompiledText&&) = delete;
    CompiledText& operator=(CompiledText&&) = delete;
    ~CompiledText() = default;

    double operator()(double argument) {
        variable_ = argument;
        return parser_.Eval();
    }

private:
    mu::Parser parser_;
    double variable_ = 0;
};

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
            fault.offset = text.size();
            break;
        case mu::ecMISSING_PARENS:
            fault.message = "a ')' is missing";
            break;
        case mu::ecUNEXPECTED_PARENS:
            fault.message = "a parenthesis where none can stand";
            break;
        case mu::ecUNEXPECTED_OPERATOR:
        case mu::ecUNASSIGNABLE_TOKEN:
            fault.message = "an operator where a value should stand";
            break;
        case mu::ecTOO_MANY_PARAMS:
            fault.message = fmt::format("too many arguments");
            break;
        case mu::ecTOO_FEW_PARAMS:
            fault.message = fmt::format("too few arguments");
            break;
        case mu::ecEXPRESSION_TOO_LONG:
            fault.message = "the expression is too long";
            break;
        case mu::ecIDENTIFIER_TOO_LONG:
            fault.message = "a name in the expression is too long";
            break;
        default:
            fault.message = token.empty() ? "this is not an arithmetic expression"
                                          : fmt::format("unexpected '{}'", token);
    }
    return fault;
}

/// Compiled copies of one text, as many as threads have ever asked at once.
class CopiesForThreads {
public:
    CopiesForThreads(std::string text, std::string variable, std::map<std::string, double> values)
        : text_(std::move(text)), variable_(std::move(variable)), values_(std::move(values)) {}

    double operator()(double argument) {
        std::unique_ptr<CompiledText> mine = take();
        const double value = (*mine)(argument);
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
        return std::make_unique<CompiledText>(text_, variable_, values_);
    }

    std::string text_;
    std::string variable_;
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
    if (begin == end || !is_digit(*begin)) return std::nullopt;
    const auto [stop, error] = std::from_chars(begin, end, value);
    if (error != std::errc() || stop != end) return std::nullopt;
    return negative ? -value : value;
}

}  // namespace

std::variant<double, ExpressionFault> evaluate(const std::string& text, ParameterScope& scope) {
    if (const std::optional<double> number = plain_number(text)) return *number;
    const std::string no_variable;
    Scan scan(text, no_variable, scope);
    if (std::optional<ExpressionFault> fault = scan.run()) return std::move(*fault);
    if (scan.has_unknown_value) return ExpressionFault{};
    double value = 0;
    try {
        value = CompiledText(text, no_variable, scan.values)(0);
    } catch (const mu::ParserError& error) {
        return fault_of(error, text);
    }
    if (!std::isfinite(value)) {
        return ExpressionFault{
            fmt::format("'{}' is not finite: its value is {}", text,
                        std::isnan(value) ? "not a number" : fmt::format("{}", value)),
            {},
            0,
            text.size()};
    }
    return value;
}

std::variant<std::function<double(double)>, ExpressionFault> compile(const std::string& text,
                                                                     const std::string& variable,
                                                                     ParameterScope& scope) {
    if (scope.values.contains(variable)) {
        return ExpressionFault{
            fmt::format("'{}' is the variable of a formula, and a parameter has the same name",
                        variable),
            "rename the parameter", 0, text.size()};
    }
    Scan scan(text, variable, scope);
    if (std::optional<ExpressionFault> fault = scan.run()) return std::move(*fault);
    if (scan.has_unknown_value) return ExpressionFault{};
    auto copies = std::make_shared<CopiesForThreads>(text, variable, std::move(scan.values));
    try {
        (*copies)(0.5);
    } catch (const mu::ParserError& error) {
        return fault_of(error, text);
    }
    return [copies](double argument) { return (*copies)(argument); };
}

bool is_reserved_in_expressions(const std::string& name) {
    return is_function(name) || constant(name).has_value() || name == "log";
}

}  // namespace hexweave
