#include "session/search_record.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace delos::session {
namespace {

Json list_of(const std::vector<double>& values) {
  Json list = Json::array();
  for (const double value : values) list.push_back(number(value));
  return list;
}

Json round_json(const SearchedRound& round) {
  Json logarithmic = Json::array();
  for (const char log : round.logarithmic) logarithmic.push_back(log != 0);
  return {{"round", round.number},
          {"variables", round.paths},
          {"lower", list_of(round.lower)},
          {"upper", list_of(round.upper)},
          {"logarithmic", logarithmic}};
}

Json searched_json(const SearchedDesign& design, double sign) {
  return {{"evaluation", design.evaluation},
          {"round", design.round},
          {"objective", number(sign * design.objective)},
          {"soft", design.soft},
          {"feasible", design.feasible},
          {"values", list_of(design.values)}};
}

}  // namespace

void SearchRecord::begin_round(int number, const Scene& scene,
                               PluginRegistry& plugins) {
  SearchedRound round;
  round.number = number;
  for (const VariableEntry& v : scene.variables) {
    round.paths.push_back(v.path);
    round.lower.push_back(v.lower);
    round.upper.push_back(v.upper);
    round.logarithmic.push_back(v.scale == ParamScale::log);
  }
  rounds_.push_back(std::move(round));
  if (rounds_.size() > kMostRounds) forget_round();
  begun_ = false;
  waiting_.reset();
  converter_ = std::make_unique<::delos::Design>(scene, plugins);
  counted_.clear();
  best_.reset();
}

/// The first, with all its designs.
void SearchRecord::forget_round() {
  const int first = rounds_.front().number;
  const auto of_first = [&](const SearchedDesign& one) { return one.round == first; };
  forgotten_ += std::erase_if(incumbents_, of_first);
  std::erase_if(designs_, of_first);
  rounds_.erase(rounds_.begin());
}

void SearchRecord::part_from_rounds(int last) {
  parted_ = std::max(parted_, last);
  best_.reset();
  waiting_.reset();
}

void SearchRecord::add(const StudyEvaluation& evaluation) {
  const auto start = static_cast<std::size_t>(evaluation.key.start);
  if (counted_.size() <= start) counted_.resize(start + 1, 0);
  if (evaluation.key.number < counted_[start]) return;
  counted_[start] = evaluation.key.number + 1;

  SearchedDesign design{++evaluations_,       evaluation.round,    evaluation.objective,
                        evaluation.width > 0, evaluation.feasible, {}};
  for (std::size_t i = 0; i < evaluation.x.size(); ++i)
    design.values.push_back(converter_->value(i, evaluation.x[i]));
  const bool begins = start == 0 && !begun_;
  begun_ = begun_ || begins;
  if (!design.soft && design.feasible && design.round > parted_) improve(design);
  if (const auto waiting = begins ? std::exchange(waiting_, {}) : std::nullopt)
    improve(*waiting);
  keep(std::move(design));
}

void SearchRecord::improve(const SearchedDesign& design) {
  std::optional<SearchedDesign>& best = begun_ ? best_ : waiting_;
  if (best && design.objective >= best->objective) return;
  best = design;
  if (!begun_) return;
  incumbents_.push_back(design);
  if (incumbents_.size() <= kMostIncumbents) return;
  incumbents_.erase(incumbents_.begin());
  ++forgotten_;
}

/// Evenly over all evaluations: those whose number the stride divides.
void SearchRecord::keep(SearchedDesign design) {
  if (design.evaluation % stride_ != 0) return;
  designs_.push_back(std::move(design));
  if (designs_.size() <= kMostDesigns) return;
  stride_ *= 2;
  std::erase_if(designs_, [&](const SearchedDesign& one) {
    return one.evaluation % stride_ != 0;
  });
}

VariableValues SearchRecord::values(const SearchedDesign& design) const {
  const auto round =
      std::find_if(rounds_.begin(), rounds_.end(),
                   [&](const SearchedRound& r) { return r.number == design.round; });
  return {round->paths, design.values};
}

VariableValues SearchRecord::values(std::size_t incumbent) const {
  if (incumbent < forgotten_ || incumbent >= incumbents())
    throw std::invalid_argument("the search keeps no design " +
                                std::to_string(incumbent));
  return values(incumbents_[incumbent - forgotten_]);
}

Json SearchRecord::json(const Heard& heard, double sign) const {
  Json rounds = Json::array(), incumbents = Json::array(), designs = Json::array();
  for (const SearchedRound& round : rounds_)
    if (round.number > heard.round) rounds.push_back(round_json(round));
  for (std::size_t i = std::max(heard.incumbents, forgotten_); i < this->incumbents();
       ++i) {
    Json one = searched_json(incumbents_[i - forgotten_], sign);
    one["number"] = i;
    incumbents.push_back(std::move(one));
  }
  for (const SearchedDesign& design : designs_)
    if (design.evaluation > heard.evaluations)
      designs.push_back(searched_json(design, sign));
  return {{"rounds", rounds},
          {"evaluations", evaluations_},
          {"incumbents", incumbents},
          {"designs", designs}};
}

}  // namespace delos::session
