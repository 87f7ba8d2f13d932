// Formulas in text: parsed once, evaluated over any kind of number.
#pragma once

#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "delos/api.h"

namespace delos {

/// What an expression may speak of. A name's index is its place in `words`; the entries
/// of the matrix follow, row after row.
struct ExpressionNames {
  std::vector<std::string> words;
  std::string matrix;                ///< "P", as in P[x, y]; empty: there is none
  std::vector<std::string> indices;  ///< of its rows and columns

  [[nodiscard]] int entry(int row, int column) const {
    return static_cast<int>(words.size() +
                            indices.size() * static_cast<std::size_t>(row)) +
           column;
  }
};

/// One step of an expression in postfix notation: a number or a name's value is put on
/// the stack, or what is on top of it is replaced by what the operation makes of it.
enum class Operation : unsigned char {
  number,
  name,
  negate,  // of one value: from here
  sqrt,
  exp,
  log,
  log10,
  sin,
  cos,
  abs,
  add,  // of two: from here
  subtract,
  multiply,
  divide,
  power,
  min,
  max,
  atan2,
};

/// A formula, ready to be evaluated.
struct Expression {
  struct Step {
    Operation operation = Operation::number;
    int name = 0;          ///< of Operation::name: its place in `names`
    double number = 0;     ///< of Operation::number
    std::size_t from = 0;  ///< where in `text` it stands
  };

  std::string text;
  std::vector<Step> steps;
  std::vector<int> names;  ///< those that it uses: indices of ExpressionNames
};

/// Most values on the stack, names and characters of an expression: what is evaluated
/// needs no heap, and what is parsed can't exhaust the program's stack.
inline constexpr int kMostStack = 32;
inline constexpr int kMostNames = 32;
inline constexpr std::size_t kMostCharacters = 500;

/// Why a text isn't an expression.
struct ExpressionProblem {
  std::size_t at = 0;  ///< the character that it is about, from 0
  std::string sentence;
};

/// Read a formula: numbers, names, + − * / ^ and parentheses, with the usual
/// precedence (−x^2 is −(x^2), 2^3^2 is 2^9); sqrt, exp, log, log10, sin, cos, abs,
/// atan2(y, x), min and max of two or more; pi; entries of a matrix as P[x, y].
[[nodiscard]] DELOS_API std::variant<Expression, ExpressionProblem> parse_expression(
    std::string_view text, const ExpressionNames& names);

/// The value of an expression.
/// @tparam T a number: double, Dual, or what knows of numbers only what is asked; made
///           of a double, with the operators and functions that a double has
/// @param values of the names that it uses, in the order of Expression::names
template <class T>
[[nodiscard]] T evaluate(const Expression& expression, const T* values) {
  using std::abs, std::atan2, std::cos, std::exp, std::log, std::log10, std::max,
      std::min, std::pow, std::sin, std::sqrt;
  T stack[kMostStack];
  int top = -1;
  for (const Expression::Step& step : expression.steps) {
    const bool of_two = step.operation >= Operation::add;
    if (of_two) --top;
    T* at = stack + top;
    switch (step.operation) {
      case Operation::number:
        stack[++top] = T(step.number);
        break;
      case Operation::name:
        stack[++top] = values[step.name];
        break;
      case Operation::negate:
        *at = -*at;
        break;
      case Operation::sqrt:
        *at = sqrt(*at);
        break;
      case Operation::exp:
        *at = exp(*at);
        break;
      case Operation::log:
        *at = log(*at);
        break;
      case Operation::log10:
        *at = log10(*at);
        break;
      case Operation::sin:
        *at = sin(*at);
        break;
      case Operation::cos:
        *at = cos(*at);
        break;
      case Operation::abs:
        *at = abs(*at);
        break;
      case Operation::add:
        *at = at[0] + at[1];
        break;
      case Operation::subtract:
        *at = at[0] - at[1];
        break;
      case Operation::multiply:
        *at = at[0] * at[1];
        break;
      case Operation::divide:
        *at = at[0] / at[1];
        break;
      case Operation::power:
        *at = pow(at[0], at[1]);
        break;
      case Operation::min:
        *at = min(at[0], at[1]);
        break;
      case Operation::max:
        *at = max(at[0], at[1]);
        break;
      case Operation::atan2:
        *at = atan2(at[0], at[1]);
        break;
    }
  }
  return stack[0];
}

}  // namespace delos
