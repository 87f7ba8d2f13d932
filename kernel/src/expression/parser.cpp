// The grammar of expressions, by Boost.Spirit X3, and what it makes of them.
#include <algorithm>
#include <boost/spirit/home/x3.hpp>
#include <cmath>
#include <numbers>

#include "delos/expression/expression.h"
#include "delos/text/numbers.h"
#include "delos/text/words.h"
#include "text/nearest.h"

namespace delos {
namespace {

namespace x3 = boost::spirit::x3;

using Letter = std::string_view::const_iterator;
using Word = boost::iterator_range<Letter>;

struct Function {
  const char* name;
  Operation operation;
};
constexpr Function kFunctions[] = {
    {"sqrt", Operation::sqrt},   {"exp", Operation::exp}, {"log", Operation::log},
    {"log10", Operation::log10}, {"sin", Operation::sin}, {"cos", Operation::cos},
    {"abs", Operation::abs},     {"min", Operation::min}, {"max", Operation::max},
    {"atan2", Operation::atan2},
};

/// What a name of the text turned out to be used for.
struct Mention {
  std::string name;
  std::size_t at = 0;
  std::vector<Mention> indices;  // of a matrix
  int arguments = 0;             // of a function
};

/// Writes the steps while the grammar reads the text.
class Builder {
 public:
  Builder(std::string_view text, const ExpressionNames& names)
      : text_(text), names_(names) {
    out_.text = text;
  }

  void number(Word word) {
    const std::string_view digits(&*word.begin(), word.size());
    const NumberText number = scan_number(digits);
    if (!number.problem.empty() || number.length != digits.size())
      fail(word, '\'' + std::string(digits) + "' isn't a number that can be taken");
    push({Operation::number, 0, number.value, offset(word)});
  }

  void mention(Word word) {
    open_.push_back({{word.begin(), word.end()}, offset(word), {}, 0});
  }
  void index(Word word) {
    open_.back().indices.push_back({{word.begin(), word.end()}, offset(word), {}, 0});
  }

  /// One more argument of a function is on the stack.
  void argument() {
    Mention& call = open_.back();
    if (++call.arguments < 2) return;
    const Operation operation = function(call);
    if (operation < Operation::add)
      throw ExpressionProblem{call.at, call.name + " takes one value"};
    if (operation == Operation::atan2 && call.arguments > 2)
      throw ExpressionProblem{call.at, call.name + " takes two values"};
    apply(operation, call.at);
  }

  void call() {
    const Mention call = close();
    const Operation operation = function(call);
    if (operation < Operation::add)
      apply(operation, call.at);
    else if (call.arguments < 2)
      throw ExpressionProblem{call.at,
                              call.name + " takes two values" +
                                  (operation == Operation::atan2 ? "" : " or more")};
  }

  void entry() {
    const Mention matrix = close();
    if (matrix.name != names_.matrix || matrix.name.empty())
      throw ExpressionProblem{matrix.at,
                              '\'' + matrix.name + "' has no entries" + known()};
    int at[2];
    for (std::size_t i = 0; i < 2; ++i) {
      const Mention& index = matrix.indices[i];
      const auto found =
          std::find(names_.indices.begin(), names_.indices.end(), index.name);
      if (found == names_.indices.end())
        throw ExpressionProblem{index.at, '\'' + index.name + "' is no state" +
                                              meant(index.name, names_.indices) +
                                              "; there are " + joined(names_.indices)};
      at[i] = static_cast<int>(found - names_.indices.begin());
    }
    use(names_.entry(at[0], at[1]), matrix.at);
  }

  void word() {
    const Mention word = close();
    if (word.name == "pi") {
      push({Operation::number, 0, std::numbers::pi, word.at});
      return;
    }
    const auto found = std::find(names_.words.begin(), names_.words.end(), word.name);
    if (found == names_.words.end())
      throw ExpressionProblem{word.at, '\'' + word.name + "' isn't known here" +
                                           meant(word.name, names_.words) + known()};
    use(static_cast<int>(found - names_.words.begin()), word.at);
  }

  /// @param at the operator
  void apply(Operation operation, std::size_t at) {
    if (operation >= Operation::add) --depth_;
    out_.steps.push_back({operation, 0, 0, at});
  }

  [[nodiscard]] std::size_t offset(Letter at) const {
    return static_cast<std::size_t>(at - text_.begin());
  }
  [[nodiscard]] std::size_t offset(Word word) const { return offset(word.begin()); }

  [[nodiscard]] Expression take() { return std::move(out_); }

 private:
  [[noreturn]] void fail(Word word, std::string sentence) const {
    throw ExpressionProblem{offset(word), std::move(sentence)};
  }

  Mention close() {
    Mention last = std::move(open_.back());
    open_.pop_back();
    return last;
  }

  static Operation function(const Mention& call) {
    std::vector<std::string> all;
    for (const Function& f : kFunctions) {
      if (call.name == f.name) return f.operation;
      all.emplace_back(f.name);
    }
    throw ExpressionProblem{call.at, "there is no function '" + call.name + '\'' +
                                         meant(call.name, all) + "; there are " +
                                         joined(all)};
  }

  static std::string meant(const std::string& name,
                           const std::vector<std::string>& all) {
    const std::string near = nearest(name, all);
    return near.empty() ? "" : "; did you mean '" + near + "'?";
  }

  [[nodiscard]] std::string known() const {
    std::string text = "; there are " + joined(names_.words);
    if (!names_.matrix.empty())
      text += ", and " + names_.matrix + "[row, column] of " + joined(names_.indices);
    return text;
  }

  void use(int name, std::size_t at) {
    auto found = std::find(out_.names.begin(), out_.names.end(), name);
    if (found == out_.names.end()) {
      if (out_.names.size() == kMostNames)
        throw ExpressionProblem{at, "is the " + std::to_string(kMostNames + 1) +
                                        "th name; an expression has at most " +
                                        std::to_string(kMostNames)};
      found = out_.names.insert(out_.names.end(), name);
    }
    push({Operation::name, static_cast<int>(found - out_.names.begin()), 0, at});
  }

  void push(const Expression::Step& step) {
    if (++depth_ > kMostStack)
      throw ExpressionProblem{step.from, "is nested too deeply: more than " +
                                             std::to_string(kMostStack) +
                                             " values wait for their operators"};
    out_.steps.push_back(step);
  }

  std::string_view text_;
  const ExpressionNames& names_;
  Expression out_;
  std::vector<Mention> open_;
  int depth_ = 0;
};

struct BuilderTag;
template <class Context>
Builder& builder(const Context& context) {
  return x3::get<BuilderTag>(context).get();
}

template <void (Builder::*act)(Word)>
constexpr auto kWith = [](auto& c) { (builder(c).*act)(x3::_attr(c)); };
template <void (Builder::*act)()>
constexpr auto kDo = [](auto& c) { (builder(c).*act)(); };
template <Operation operation>
constexpr auto kApply = [](auto& c) {
  builder(c).apply(operation, builder(c).offset(x3::_where(c).begin()));
};

// What messages say was expected where none of these begins.
constexpr const char* kValue = "a number, a name or '('";
struct SumRule;
struct ProductRule;
struct SignedRule;
constexpr x3::rule<SumRule> kSum = kValue;
constexpr x3::rule<ProductRule> kProduct = kValue;
constexpr x3::rule<SignedRule> kSigned = kValue;

const auto kDigits = +x3::digit;
const auto kNumber =
    x3::raw[x3::lexeme[(kDigits >> -('.' >> *x3::digit) | '.' >> kDigits) >>
                       -(x3::char_("eE") >> -x3::char_("+-") >> kDigits)]];
const auto kWord = x3::raw[x3::lexeme[(x3::alpha | '_') >> *(x3::alnum | '_')]];
const auto kIndex = x3::raw[x3::lexeme[+(x3::graph - ',' - ']')]];

const auto kArgument = kSum >> x3::eps[kDo<&Builder::argument>];
const auto kName = kWord[kWith<&Builder::mention>] >>
                   (('(' > (kArgument % ',') > ')' > x3::eps[kDo<&Builder::call>]) |
                    ('[' > kIndex[kWith<&Builder::index>] > ',' >
                     kIndex[kWith<&Builder::index>] > ']' >
                     x3::eps[kDo<&Builder::entry>]) |
                    x3::eps[kDo<&Builder::word>]);
const auto kPrimary = kNumber[kWith<&Builder::number>] | ('(' > kSum > ')') | kName;
const auto kPower = kPrimary >> -('^' > kSigned > x3::eps[kApply<Operation::power>]);
const auto kSigned_def =
    ('-' > kSigned > x3::eps[kApply<Operation::negate>]) | ('+' > kSigned) | kPower;
const auto kProduct_def = kSigned >>
                          *(('*' > kSigned > x3::eps[kApply<Operation::multiply>]) |
                            ('/' > kSigned > x3::eps[kApply<Operation::divide>]));
const auto kSum_def = kProduct >>
                      *(('+' > kProduct > x3::eps[kApply<Operation::add>]) |
                        ('-' > kProduct > x3::eps[kApply<Operation::subtract>]));

BOOST_SPIRIT_DEFINE(kSum, kProduct, kSigned)

}  // namespace

std::variant<Expression, ExpressionProblem> parse_expression(
    std::string_view text, const ExpressionNames& names) {
  if (text.size() > kMostCharacters)
    return ExpressionProblem{kMostCharacters, "is longer than " +
                                                  std::to_string(kMostCharacters) +
                                                  " characters; name parts of it"};
  Builder build(text, names);
  Letter at = text.begin();
  const auto unexpected = [&](Letter where, const std::string& wanted) {
    const std::string found = where == text.end()
                                  ? std::string("the end")
                                  : '\'' + std::string(1, *where) + '\'';
    return ExpressionProblem{build.offset(where),
                             "expected " + wanted + ", found " + found};
  };
  const auto skip_blanks = [&](Letter& letter) {
    while (letter != text.end() &&
           (*letter == ' ' || *letter == '\t' || *letter == '\n'))
      ++letter;
  };
  try {
    const auto grammar = x3::with<BuilderTag>(std::ref(build))[kSum];
    const bool read = x3::phrase_parse(at, text.end(), grammar, x3::space);
    skip_blanks(at);
    if (!read) return unexpected(at, kValue);
    if (at != text.end()) return unexpected(at, "an operator or the end");
    return build.take();
  } catch (const ExpressionProblem& problem) {
    return problem;
  } catch (const x3::expectation_failure<Letter>& failure) {
    Letter where = failure.where();
    skip_blanks(where);
    return unexpected(where, failure.which());
  }
}

}  // namespace delos
