// SPDX-License-Identifier: Apache-2.0
#include "topology/expressions.h"

#include <catch2/catch.hpp>
#include <clocale>
#include <cmath>
#include <locale>
#include <numbers>
#include <thread>

using namespace hexweave;

namespace {

ParameterScope parameters() {
    ParameterScope scope;
    scope.values = {{"chord", 2.0}, {"a1", 3.0}, {"broken", std::nullopt}};
    scope.later = {"span"};
    return scope;
}

double value(const std::string& text) {
    ParameterScope scope = parameters();
    const auto result = evaluate(text, scope);
    INFO(text);
    REQUIRE(std::holds_alternative<double>(result));
    return std::get<double>(result);
}

/// offset+length message
std::string fault(const std::string& text) {
    ParameterScope scope = parameters();
    const auto result = evaluate(text, scope);
    INFO(text);
    REQUIRE(std::holds_alternative<ExpressionFault>(result));
    const auto& f = std::get<ExpressionFault>(result);
    return std::to_string(f.offset) + "+" + std::to_string(f.length) + " " + f.message;
}

std::function<double(double)> function_of_t(const std::string& text) {
    ParameterScope scope = parameters();
    auto result = compile(text, "t", scope);
    REQUIRE(std::holds_alternative<std::function<double(double)>>(result));
    return std::get<std::function<double(double)>>(result);
}

}  // namespace

TEST_CASE("numbers are read as they stand, to the last bit") {
    CHECK(value("1") == 1);
    CHECK(value("-2.5e-3") == -2.5e-3);
    CHECK(value("+4") == 4);
    CHECK(value("010") == 10);
    CHECK(value(".5") == 0.5);
    CHECK(value("1.") == 1);
    CHECK(value("0.1") == 0.1);
    CHECK(value("1e3") == 1000);
    CHECK(value(" 7 ") == 7);
    CHECK(value("1e-5 * 1") == 1e-5);
}

TEST_CASE("operators bind as in mathematics, and the power to the right") {
    CHECK(value("1 + 2*3") == 7);
    CHECK(value("(1 + 2)*3") == 9);
    CHECK(value("8/4/2") == 1);
    CHECK(value("2 - 3 - 4") == -5);
    CHECK(value("2^3^2") == 512);
    CHECK(value("-2^2") == -4);
    CHECK(value("2^-1") == 0.5);
    CHECK(value("2*-3") == -6);
    CHECK(value("-chord^2*a1") == -12);
}

TEST_CASE("comparisons give 1 or 0, exactly, and choose") {
    CHECK(value("a1 > chord") == 1);
    CHECK(value("a1 < chord") == 0);
    CHECK(value("a1 >= 3 && chord <= 2") == 1);
    CHECK(value("a1 == 3 + 1e-15") == 0);
    CHECK(value("a1 != 3 + 1e-15") == 1);
    CHECK(value("a1 == 3 || 0") == 1);
    CHECK(value("!(a1 == 3)") == 0);
    CHECK(value("!0 == 1") == 1);
    CHECK(value("2 * (a1 > 2) + 1") == 3);
    CHECK(value("a1 > 5 ? 10 : a1 > 2 ? 20 : 30") == 20);
    CHECK(value("1 + 1 < 3 && 2 < 3") == 1);
    CHECK(value("max(1 < 2, 0 > 3)") == 1);
    const auto f = function_of_t("t < 0.5 ? t : 1 - t");
    CHECK(f(0.25) == 0.25);
    CHECK(f(0.75) == 0.25);
}

TEST_CASE("slips in comparisons are told") {
    CHECK(fault("1 < a1 < 5") == "7+1 comparisons do not chain");
    CHECK(fault("a1 > 2 & 1") == "7+1 '&' has no place in an expression");
    CHECK(fault("a1 > 2 | 1") == "7+1 '|' has no place in an expression");
    CHECK(fault("a1 ? 1").substr(4) == "a '?' without its ':'");
    CHECK(fault("a1 : 1").substr(4) == "a ':' without a '?' before it");
    CHECK(fault("a1 >").substr(4) == "the expression ends too early");
}

TEST_CASE("functions take radians, and each means one thing") {
    CHECK(value("sin(pi/2)") == 1);
    CHECK(value("cos(pi)") == -1);
    CHECK(value("atan2(1, 1)") == Approx(std::numbers::pi / 4).epsilon(1e-15));
    CHECK(value("ln(e)") == Approx(1).epsilon(1e-15));
    CHECK(value("log10(1000)") == Approx(3).epsilon(1e-15));
    CHECK(value("exp(1)") == std::exp(1.0));
    CHECK(value("sqrt(abs(-9))") == 3);
    CHECK(value("cbrt(27)") == Approx(3).epsilon(1e-15));
    CHECK(value("min(3, 1, 2) + max(4)") == 5);
    CHECK(value("floor(-1.5)") == -2);
    CHECK(value("ceil(1.2)") == 2);
    CHECK(value("asin(sin(0.3)) + acos(cos(0.3)) + atan(tan(0.3))") == Approx(0.9).epsilon(1e-14));
    CHECK(value("asinh(sinh(2)) + acosh(cosh(2)) + atanh(tanh(2))") == Approx(6).epsilon(1e-13));
}

TEST_CASE("faults stand at the character where they are") {
    CHECK(fault("1 + chrod") == "4+5 unknown parameter 'chrod'");
    CHECK(fault("2*span") == "2+4 the parameter 'span' is used before it is defined");
    CHECK(fault("1 + 2x") == "4+2 '2x' is neither a number nor a name");
    CHECK(fault("chord a1") == "6+2 an operator is missing before 'a1'");
    CHECK(fault("chord(2)") == "0+5 an operator is missing between 'chord' and '('");
    CHECK(fault("(1)2") == "3+1 an operator is missing before '2'");
    CHECK(fault("sin") == "0+3 the function 'sin' lacks its argument in parentheses");
    CHECK(fault("1 + foo(2)") == "4+3 there is no function 'foo'");
    CHECK(fault("1e999") == "0+5 the number 1e999 is out of range");
    CHECK(fault("1 + .5x") == "4+3 '.5x' is neither a number nor a name");
    CHECK(fault("-.") == "1+1 a '.' without digits");
    CHECK(fault("2 * .nan") == "4+4 a number must be finite, not '.nan'");
    CHECK(fault("-INF") == "1+3 a number must be finite, not 'INF'");
    CHECK(fault("infinite") == "0+8 unknown parameter 'infinite'");
    CHECK(fault("1 +") == "3+1 the expression ends too early");
    CHECK(fault("   ") == "3+1 the expression ends too early");
    CHECK(fault("2 * / 3") == "4+1 an operator where a value should stand");
    CHECK(fault("(1 + 2))") == "7+1 a parenthesis where none can stand");
}

TEST_CASE("what is not arithmetic is refused") {
    CHECK(fault("chord = 3") == "6+1 '=' has no place in an expression");
    CHECK(fault("1, 2") == "1+1 a ',' where none can stand");
    CHECK(fault("(1, 2)") == "2+1 a ',' where none can stand");
    CHECK(fault("\"text\"") == "0+1 '\"' has no place in an expression");
    CHECK(fault("#101") == "0+1 '#' has no place in an expression");
    CHECK(fault("0x10") == "0+4 '0x10' is neither a number nor a name");
    CHECK(fault("2**3") == "1+2 '**' is not an operator");
    CHECK(fault("sum(1, 2)") == "0+3 there is no function 'sum'");
    CHECK(fault("_pi") == "0+3 unknown parameter '_pi'");
    CHECK(fault("nan") == "0+3 a number must be finite, not 'nan'");
    CHECK(fault("1 + \xC3\xA9") == "4+1 '\xC3\xA9' has no place in an expression");
}

TEST_CASE("values are finite, and a faulty parameter is not told twice") {
    CHECK(fault("1/0") == "0+3 '1/0' is not finite: its value is inf");
    CHECK(fault("-exp(1000)") == "0+10 '-exp(1000)' is not finite: its value is -inf");
    CHECK(fault("sqrt(-1)") == "0+8 'sqrt(-1)' is not finite: its value is not a number");
    CHECK(fault("broken + 1") == "0+1 ");
    CHECK(fault("broken + unknown") == "9+7 unknown parameter 'unknown'");
}

TEST_CASE("the names that expressions use are kept") {
    ParameterScope scope = parameters();
    evaluate("2*chord + sin(pi)", scope);
    CHECK(scope.used == std::set<std::string>{"chord"});
}

TEST_CASE("the locale does not matter") {
    class Comma : public std::numpunct<char> {
        char do_decimal_point() const override { return ','; }
        std::string do_grouping() const override { return "\3"; }
    };
    const std::locale before = std::locale::global(std::locale(std::locale(), new Comma));
    const double number = value("1.5");
    const double sum = value("1.5 + 1000.25");
    const std::string refused = fault("1,5");
    std::locale::global(before);
    CHECK(number == 1.5);
    CHECK(sum == 1001.75);
    CHECK(refused == "1+1 a ',' where none can stand");
}

TEST_CASE("a formula is a function of its variable and of the parameters' values") {
    const auto f = function_of_t("chord*t^2 + sin(t)");
    CHECK(f(0) == 0);
    CHECK(f(2) == Approx(8 + std::sin(2.0)).epsilon(1e-15));
    CHECK(std::isinf(function_of_t("1/t")(0)));

    ParameterScope scope = parameters();
    scope.values["t"] = 1;
    CHECK(std::holds_alternative<ExpressionFault>(compile("t", "t", scope)));
    CHECK(std::get<ExpressionFault>(compile("2*u", "t", scope)).message ==
          "'t' is the variable of a formula, and a parameter has the same name");
}

TEST_CASE("a formula gives the same from several threads at once") {
    const auto f = function_of_t("sin(t)*exp(-t) + t^3");
    std::vector<int> wrong(4, 0);
    std::vector<std::thread> threads;
    for (std::size_t n = 0; n < wrong.size(); ++n) {
        threads.emplace_back([&wrong, &f, n] {
            for (int i = 0; i < 2000; ++i) {
                const double t = 0.001 * i + static_cast<double>(n);
                const double expected = std::sin(t) * std::exp(-t) + t * t * t;
                if (std::abs(f(t) - expected) > 1e-12 * (1 + expected)) ++wrong[n];
            }
        });
    }
    for (std::thread& thread : threads) thread.join();
    CHECK(wrong == std::vector<int>(4, 0));
}

TEST_CASE("functions and constants are no names for parameters") {
    CHECK(is_reserved_in_expressions("pi"));
    CHECK(is_reserved_in_expressions("e"));
    CHECK(is_reserved_in_expressions("min"));
    CHECK_FALSE(is_reserved_in_expressions("wall"));
}
