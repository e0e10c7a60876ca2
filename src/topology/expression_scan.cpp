// SPDX-License-Identifier: Apache-2.0
#include "topology/expression_scan.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <numbers>
#include <utility>
#include <vector>

#include "core/diagnostics.h"
#include "core/utf8.h"
#include "topology/source_text.h"

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

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}
bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\n';
}

/// Whether a word is what YAML and other programs write for numbers that are none: ".nan", "Inf".
bool is_not_finite(std::string word) {
    for (char& c : word) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return word == ".nan" || word == ".inf" || word == "nan" || word == "inf" || word == "infinity";
}

class Scan {
public:
    Scan(const std::string& text, const std::vector<std::string>& variables, ParameterScope& scope)
        : text_(text), variables_(variables), scope_(scope) {}

    ScannedExpression run() {
        while (at_ < text_.size() && !result_.fault) result_.fault = next();
        return std::move(result_);
    }

private:
    std::optional<ExpressionFault> next() {
        const char c = text_[at_];
        if (is_letter(c)) return name();
        if (is_digit(c) || c == '.') return number();
        if (c == '(' && after_value_) return operator_missing("(", 1);
        if (c == '(') {
            calls_.push_back(after_function_);
            comparisons_.push_back(false);
        }
        if (c == ')' && !calls_.empty()) {
            calls_.pop_back();
            comparisons_.pop_back();
        }
        if (const std::size_t length = logical_operator()) return logic(length);
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
        if (c == ',') comparisons_.back() = false;
        if (!is_blank(c)) after_function_ = false;
        after_value_ = c == ')' || (is_blank(c) && after_value_);
        ++at_;
        return std::nullopt;
    }

    /// The length of the comparison or logical operator that stands here, or 0.
    std::size_t logical_operator() const {
        for (const std::string_view two : {"==", "!=", "<=", ">=", "&&", "||"}) {
            if (text_.compare(at_, 2, two) == 0) return 2;
        }
        return std::string_view("<>!?:").find(text_[at_]) == std::string_view::npos ? 0 : 1;
    }

    std::optional<ExpressionFault> logic(std::size_t length) {
        const std::string written = text_.substr(at_, length);
        const bool compares =
            std::string_view("== != <= >=").find(written) != std::string::npos && written != "!";
        if (compares && comparisons_.back()) {
            return ExpressionFault{"comparisons do not chain",
                                   "write 'a < b && b < c' for 'a < b < c'", at_, length};
        }
        if (written != "!") comparisons_.back() = compares;
        after_function_ = false;
        after_value_ = false;
        at_ += length;
        return std::nullopt;
    }

    ExpressionFault foreign_character() const {
        std::size_t bytes = 1;
        while (at_ + bytes < text_.size() && is_utf8_continuation(text_[at_ + bytes])) ++bytes;
        const char* hint = is_per_cent() ? "write per cent as a part of 1: 0.1 % is 0.001"
                                         : remedy(std::string_view(text_).substr(at_, bytes));
        return {fmt::format("'{}' has no place in an expression", text_.substr(at_, bytes)), hint,
                at_, 1};
    }

    /// A '%' behind a value, with no other value behind it.
    bool is_per_cent() const {
        if (text_[at_] != '%' || !after_value_) return false;
        const std::size_t next = text_.find_first_not_of(' ', at_ + 1);
        return next == std::string::npos ||
               std::string_view("+-*/)").find(text_[next]) != std::string_view::npos;
    }

    static const char* remedy(std::string_view character) {
        const char c = character.front();
        if (c == '%') return "there is no remainder: write a - b * floor(a / b)";
        if (character == "\u00B0") return "angles are in radians: write 90 degrees as pi / 2";
        if (c == '[' || c == '{') return "an expression is one number; parentheses are round";
        if (c == '"' || c == '\'') return "an expression has no texts";
        if (c == '=') return "two values are compared by '=='";
        if (c == '&') return "'and' is written '&&'";
        if (c == '|') return "'or' is written '||'";
        return "expressions have numbers, parameters, + - * / ^ ( ), functions, comparisons, && || "
               "! "
               "and a ? b : c";
    }

    std::optional<ExpressionFault> number() {
        double value = 0;
        const char* const begin = text_.data() + at_;
        const char* const end = text_.data() + text_.size();
        const auto [stop, error] = std::from_chars(begin, end, value);
        const auto length = std::max<std::size_t>(1, static_cast<std::size_t>(stop - begin));
        const std::string written = text_.substr(at_, length);
        if (error == std::errc::invalid_argument) return point_without_digits();
        if (error != std::errc()) {
            return ExpressionFault{fmt::format("the number {} is out of range", shown(written)),
                                   "numbers lie between 1e-307 and 1e308", at_, length};
        }
        const bool glued = stop != end && (is_letter(*stop) || is_digit(*stop) || *stop == '.');
        if (glued) return bad_number();
        if (after_value_) return operator_missing(written, length);
        at_ += length;
        after_value_ = true;
        return std::nullopt;
    }

    /// Letters, digits and points from here on.
    std::string word() const {
        std::size_t end = at_;
        while (end < text_.size() &&
               (is_letter(text_[end]) || is_digit(text_[end]) || text_[end] == '.')) {
            ++end;
        }
        return text_.substr(at_, end - at_);
    }

    ExpressionFault bad_number() const {
        const std::string written = word();
        return {fmt::format("'{}' is neither a number nor a name", shown(written)),
                glued_remedy(written), at_, written.size()};
    }

    ExpressionFault point_without_digits() const {
        const std::string written = word();
        if (is_not_finite(written)) return not_finite(written);
        return {"a '.' without digits", "write 0.5", at_, 1};
    }

    ExpressionFault not_finite(const std::string& written) const {
        return {fmt::format("a number must be finite, not '{}'", written),
                "give a number, or leave the key out", at_, written.size()};
    }

    /// What was glued to a number: a unit, a hexadecimal number, a name.
    std::string glued_remedy(const std::string& written) const {
        const std::size_t letters = written.find_first_not_of("0123456789.");
        if (letters == std::string::npos) return "a number has one decimal point";
        const std::string name = written.substr(letters);
        if (name == "deg" || name == "degrees") {
            return "angles are in radians: write 90 degrees as pi / 2";
        }
        if (is_variable(name) || scope_.values.contains(name) || constant_value(name)) {
            return fmt::format("write '*' between them: {} * {}", written.substr(0, letters), name);
        }
        return "a number has no unit of its own: that of all lengths is said once, by 'units'; "
               "between a number and a name stands '*'";
    }

    ExpressionFault operator_missing(const std::string& written, std::size_t length) const {
        return {fmt::format("an operator is missing before '{}'", shown(written)),
                "write '*' to multiply; a number has no unit of its own: that of all lengths is "
                "said once, by 'units'",
                at_, length};
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
        if (is_function_name(name)) return std::nullopt;
        ExpressionFault fault{
            fmt::format("there is no function '{}'", shown(name)), {}, at_, name.size()};
        std::vector<std::string> known(functions.size());
        std::transform(functions.begin(), functions.end(), known.begin(),
                       [](const Function& f) { return std::string(f.name); });
        const std::string nearest = nearest_name(name, known);
        if (name == "pow") {
            fault.hint = "the power is written '^': a^b";
        } else if (name == "round") {
            fault.hint = "write floor(x + 0.5)";
        } else if (name == "log") {
            fault.hint = "write 'ln' for the natural logarithm, 'log10' for that of base 10";
        } else if (scope_.values.contains(name) || is_variable(name) || constant_value(name)) {
            fault.message = fmt::format("an operator is missing between '{}' and '('", name);
            fault.hint = fmt::format("write '{} * (' to multiply", name);
        } else if (!nearest.empty()) {
            fault.hint = fmt::format("did you mean '{}'?", nearest);
        } else {
            fault.hint = "functions are " + fmt::format("{}", fmt::join(known, ", "));
        }
        return fault;
    }

    std::optional<ExpressionFault> value(const std::string& name) {
        if (is_variable(name)) return std::nullopt;
        if (const std::optional<double> known = constant_value(name)) {
            result_.values[name] = *known;
            return std::nullopt;
        }
        const auto found = scope_.values.find(name);
        if (found == scope_.values.end()) return unknown(name);
        scope_.used.insert(name);
        if (found->second) {
            result_.values[name] = *found->second;
        } else {
            result_.lacks_value = true;
        }
        return std::nullopt;
    }

    bool is_variable(const std::string& name) const {
        return std::find(variables_.begin(), variables_.end(), name) != variables_.end();
    }

    ExpressionFault unknown(const std::string& name) const {
        if (is_not_finite(name)) return not_finite(name);
        ExpressionFault fault{
            fmt::format("unknown parameter '{}'", shown(name)), {}, at_, name.size()};
        std::vector<std::string> known;
        for (const auto& [parameter, value] : scope_.values) known.push_back(parameter);
        const std::string nearest = nearest_name(name, known);
        if (scope_.later.contains(name)) {
            fault.message = fmt::format("the parameter '{}' is used before it is defined", name);
            fault.hint = "parameters may use only those that stand before them";
        } else if (is_function_name(name)) {
            fault.message =
                fmt::format("the function '{}' lacks its argument in parentheses", name);
            fault.hint = fmt::format("as in {}(x)", name);
        } else if (!nearest.empty()) {
            fault.hint = fmt::format("did you mean '{}'?", nearest);
        } else if (name == "PI" || name == "Pi") {
            fault.hint = "did you mean 'pi'?";
        } else if (variables_.size() == 1) {
            fault.hint = fmt::format("the variable of a formula is '{}'", variables_[0]);
        } else if (!variables_.empty()) {
            fault.hint = fmt::format("the variables of a formula are '{}'",
                                     fmt::join(variables_, "' and '"));
        } else if (!known.empty() && known.size() <= 20) {
            fault.hint = fmt::format("known parameters are {}", fmt::join(known, ", "));
        } else {
            fault.hint = fmt::format("write a number, or define it: 'parameters: {{{}: VALUE}}'",
                                     shown(name));
        }
        return fault;
    }

    const std::string& text_;
    const std::vector<std::string>& variables_;
    ParameterScope& scope_;
    ScannedExpression result_;
    std::size_t at_ = 0;
    /// By open parentheses: whether a comparison stands before, to which another must not be
    /// chained.
    std::vector<bool> comparisons_{false};
    std::vector<bool> calls_;  ///< open parentheses: whether each holds a function's arguments
    bool after_function_ = false;
    bool after_value_ = false;  ///< a number, a name or a ')' has just ended
};

}  // namespace

bool is_function_name(std::string_view name) {
    return std::any_of(functions.begin(), functions.end(),
                       [&](const Function& f) { return f.name == name; });
}

std::optional<double> constant_value(std::string_view name) {
    const auto* found = std::find_if(constants.begin(), constants.end(),
                                     [&](const auto& c) { return c.first == name; });
    return found == constants.end() ? std::nullopt : std::optional(found->second);
}

ScannedExpression scan_expression(const std::string& text,
                                  const std::vector<std::string>& variables,
                                  ParameterScope& scope) {
    return Scan(text, variables, scope).run();
}

}  // namespace hexweave
