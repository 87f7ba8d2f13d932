#include "study/parts.h"

#include <stdexcept>
#include <string>
#include <tuple>

#include "delos/scene/io.h"

namespace delos {

void check_parts(const std::vector<std::filesystem::path>& files,
                 const std::vector<Study>& parts) {
  const auto refuse = [&](std::size_t k, const std::string& what) {
    throw std::invalid_argument(files[k].string() + ' ' + what);
  };
  const StudyPlan plan = parts.front().summary().plan;
  std::vector<std::size_t> owner(plan.part.of, parts.size());
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const StudySummary s = parts[k].summary();
    if (s.plan.part.of < 2) refuse(k, "isn't a part of a search");
    if (s.rounds.size() > 1 || !s.acts.empty())
      refuse(k, "was steered, which the other parts weren't");
    if (s.plan.version != plan.version)
      refuse(k, "was begun by version " + s.plan.version + ", " + files[0].string() +
                    " by " + plan.version);
    const auto asked = [](const StudyPlan& p) {
      return std::tuple(p.algorithm, p.starts, p.evaluations, p.seed, p.samples,
                        p.part.of);
    };
    if (asked(s.plan) != asked(plan) ||
        write_scene(parts[k].scene(0)) != write_scene(parts[0].scene(0)))
      refuse(k, "is a part of another search than " + files[0].string());
    std::size_t& of = owner[s.plan.part.index];
    if (of < parts.size())
      refuse(k, "and " + files[of].string() + " are the same part");
    of = k;
  }
  std::string missing;
  for (std::size_t part = 0; part < owner.size(); ++part)
    if (owner[part] == parts.size())
      missing += (missing.empty() ? "" : ", ") + std::to_string(part + 1) + '/' +
                 std::to_string(owner.size());
  if (!missing.empty())
    throw std::invalid_argument("the part " + missing + " is missing");
}

void PartsLedger::add(const Database& part, int round) {
  parts_.push_back(std::make_unique<DatabaseLedger>(part, round, [] {}));
}

bool PartsLedger::recall(const EvaluationKey& key, std::span<const double> x,
                         EvaluationRecord& record) {
  if (whole_.recall(key, x, record)) return true;
  for (const auto& part : parts_) {
    if (!part->recall(key, x, record)) continue;
    whole_.remember(key, x, record);
    return true;
  }
  return false;
}

void PartsLedger::remember(const EvaluationKey& key, std::span<const double> x,
                           const EvaluationRecord& record) {
  whole_.remember(key, x, record);
}

void PartsLedger::each(const Told& told) { whole_.each(told); }

}  // namespace delos
