// Formulas in text: values against the same formula in C++, slopes against central
// differences, and what is refused, where.
#include "delos/expression/expression.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "delos/expression/dual.h"

namespace delos {
namespace {

const ExpressionNames kNames{{"a", "b", "sigma_x"}, "P", {"x", "y", "vx"}};
constexpr double kA = 1.7, kB = 0.3, kSigma = 2.5;

/// a, b, sigma_x, and entry (i, j) of P as 10 i + j + 0.5.
double value_of(int name) {
  if (name < 3) return name == 0 ? kA : name == 1 ? kB : kSigma;
  return 10 * ((name - 3) / 3) + (name - 3) % 3 + 0.5;
}

Expression parsed(const std::string& text) {
  auto expression = parse_expression(text, kNames);
  if (const auto* problem = std::get_if<ExpressionProblem>(&expression)) {
    ADD_FAILURE() << text << ": " << problem->sentence;
    return {};
  }
  return std::get<Expression>(std::move(expression));
}

double evaluated(const std::string& text) {
  const Expression expression = parsed(text);
  if (expression.steps.empty()) return std::nan("");
  std::vector<double> values;
  for (const int name : expression.names) values.push_back(value_of(name));
  return evaluate(expression, values.data());
}

TEST(Expression, IsWhatItIsInCpp) {
  EXPECT_EQ(evaluated("1+2*3"), 7);
  EXPECT_EQ(evaluated("(1 + 2) * 3"), 9);
  EXPECT_EQ(evaluated("7-4-2"), 1);
  EXPECT_EQ(evaluated("8/4/2"), 1);
  EXPECT_EQ(evaluated("2^3^2"), 512);
  EXPECT_EQ(evaluated("-2^2"), -4);
  EXPECT_EQ(evaluated("2^-1"), 0.5);
  EXPECT_EQ(evaluated("2*-3"), -6);
  EXPECT_EQ(evaluated("--3 + +1"), 4);
  EXPECT_EQ(evaluated("1.5e-3"), 1.5e-3);
  EXPECT_EQ(evaluated(".5 + 1."), 1.5);
  EXPECT_EQ(evaluated("pi"), std::numbers::pi);
  EXPECT_EQ(evaluated(" a\t/ b "), kA / kB);
  EXPECT_EQ(evaluated("a - b - a"), kA - kB - kA);
  EXPECT_EQ(evaluated("sqrt(a*a + b^2)"), std::sqrt(kA * kA + std::pow(kB, 2)));
  EXPECT_EQ(evaluated("exp(log(sigma_x)) + log10(a)"),
            std::exp(std::log(kSigma)) + std::log10(kA));
  EXPECT_EQ(evaluated("sin(a)*cos(b) + abs(-a)"), std::sin(kA) * std::cos(kB) + kA);
  EXPECT_EQ(evaluated("min(a, b, sigma_x) + max(a, b, sigma_x)"), kB + kSigma);
  EXPECT_EQ(evaluated("atan2(-a, b)"), std::atan2(-kA, kB));
  EXPECT_EQ(evaluated("P[x, vx] + 100*P[vx,x]"), 2.5 + 100 * 20.5);
  EXPECT_EQ(evaluated("max(P[y,y], a)/2"), 11.5 / 2);
}

// A name that is used twice is read once.
TEST(Expression, SaysWhatItReads) {
  EXPECT_EQ(parsed("b + a*b").names, (std::vector<int>{1, 0}));
  EXPECT_EQ(parsed("P[y, x]").names, std::vector<int>{kNames.entry(1, 0)});
  EXPECT_TRUE(parsed("1 + pi").names.empty());
}

struct Wrong {
  std::string text;
  std::size_t at;
  std::string begins;  // of the sentence
};

TEST(Expression, SaysWhatIsWrongAndWhere) {
  const std::string value = "expected a number, a name or '(', found ";
  for (const Wrong& wrong : std::vector<Wrong>{
           {"", 0, value + "the end"},
           {"a + ", 4, value + "the end"},
           {"a + *b", 4, value + "'*'"},
           {"(a", 2, "expected ')', found the end"},
           {"a b", 2, "expected an operator or the end, found 'b'"},
           {"a)", 1, "expected an operator or the end, found ')'"},
           {"2e", 1, "expected an operator or the end, found 'e'"},
           {"1e999", 0, "'1e999' isn't a number that can be taken"},
           {"a + sigmax", 4,
            "'sigmax' isn't known here; did you mean 'sigma_x'?; there "
            "are a, b, sigma_x, and P[row, column] of x, y, vx"},
           {"1 + foo(a)", 4, "there is no function 'foo'; there are sqrt"},
           {"sqrt(a, b)", 0, "sqrt takes one value"},
           {"1 + max(a)", 4, "max takes two values or more"},
           {"1 + atan2(a)", 4, "atan2 takes two values"},
           {"atan2(a, b, a)", 0, "atan2 takes two values"},
           {"P[x]", 3, "expected ',', found ']'"},
           {"a + P[x, vz]", 9,
            "'vz' is no state; did you mean 'vx'?; there are x, y, vx"},
           {"a[x, y]", 0, "'a' has no entries"},
           {"P", 0, "'P' isn't known here"},
           {std::string(501, '1'), 500, "is longer than 500 characters"}}) {
    const auto expression = parse_expression(wrong.text, kNames);
    const auto* problem = std::get_if<ExpressionProblem>(&expression);
    ASSERT_TRUE(problem) << wrong.text;
    EXPECT_EQ(problem->at, wrong.at) << wrong.text << ": " << problem->sentence;
    EXPECT_EQ(problem->sentence.rfind(wrong.begins, 0), 0u) << problem->sentence;
  }
}

// Whatever waits on the stack, and whatever is nested, ends as a value or a sentence.
TEST(Expression, EndsWhateverTheText) {
  std::string sum, nested;
  for (int i = 0; i < kMostStack; ++i) nested += "1+(";
  const auto deep =
      parse_expression(nested + "1" + std::string(kMostStack, ')'), kNames);
  ASSERT_TRUE(std::holds_alternative<ExpressionProblem>(deep));
  EXPECT_NE(std::get<ExpressionProblem>(deep).sentence.find("nested too deeply"),
            std::string::npos);
  EXPECT_EQ(evaluated(nested.substr(3) + "1" + std::string(kMostStack - 1, ')')),
            kMostStack);
  EXPECT_EQ(evaluated(std::string(200, '(') + "a" + std::string(200, ')')), kA);
  EXPECT_EQ(evaluated(std::string(400, '-') + "a"), kA);

  ExpressionNames many;
  for (int i = 0; i <= kMostNames; ++i) {
    many.words.push_back("n" + std::to_string(i));
    sum += (i > 0 ? "+" : "") + many.words.back();
  }
  const auto too_many = parse_expression(sum, many);
  ASSERT_TRUE(std::holds_alternative<ExpressionProblem>(too_many));
  EXPECT_EQ(std::get<ExpressionProblem>(too_many).at, sum.rfind('n'));

  std::mt19937 random(7);
  const std::string letters = "ab12.e+-*/^(),[]P xysqrtmin_";
  int taken = 0;
  for (int i = 0; i < 20000; ++i) {
    std::string text;
    for (auto n = random() % 12; n > 0; --n) text += letters[random() % letters.size()];
    const auto any = parse_expression(text, kNames);
    if (const auto* problem = std::get_if<ExpressionProblem>(&any)) {
      EXPECT_LE(problem->at, text.size());
      EXPECT_FALSE(problem->sentence.empty());
    } else {
      ++taken;
    }
  }
  EXPECT_GT(taken, 100);
}

// Steps of 1e-6 leave rounding of 1e-10 and a truncation of 1e-12 times the third
// derivative.
TEST(Expression, HasTheSlopesOfCentralDifferences) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0.3, 2);
  for (const char* text :
       {"a*b", "a/b", "a - b/a", "sqrt(a*a + b)", "exp(a/3) - b", "log(a + b)*a",
        "log10(a*b)", "sin(a*b) + cos(b)", "abs(b - 3)*a", "abs(b)", "a^3", "a^b",
        "2^a", "-a^-0.5", "min(a, b)*max(a, 2*b)", "(a + b)^2/(1 + a)", "5 - 2*b"}) {
    const Expression expression = parsed(text);
    for (int i = 0; i < 20; ++i) {
      double at[2] = {uniform(random), uniform(random)};
      for (std::size_t k = 0; k < expression.names.size(); ++k) {
        Dual<double, 1> duals[2] = {at[0], at[1]};
        duals[k].slope[0] = 1;
        const Dual<double, 1> found = evaluate(expression, duals);
        EXPECT_EQ(found.value, evaluate(expression, at));
        constexpr double kStep = 1e-6;
        double up[2] = {at[0], at[1]}, down[2] = {at[0], at[1]};
        up[k] += kStep;
        down[k] -= kStep;
        const double difference =
            (evaluate(expression, up) - evaluate(expression, down)) / (2 * kStep);
        EXPECT_NEAR(found.slope[0], difference, 1e-8 * (1 + std::abs(difference)))
            << text << " by " << k;
      }
    }
  }
}

// A power of a number below 0 has a slope where the exponent doesn't vary.
TEST(Expression, HasSlopesOfWholePowersOfNegativeNumbers) {
  const Expression cube = parsed("a^3");
  const Dual<double, 1> at(-2, 0);
  EXPECT_EQ(evaluate(cube, &at).value, -8);
  EXPECT_EQ(evaluate(cube, &at).slope[0], 12);
}

}  // namespace
}  // namespace delos
