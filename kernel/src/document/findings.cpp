#include "document/findings.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace delos {

int Findings::add_source(std::string name) {
  sources_.push_back(std::move(name));
  return static_cast<int>(sources_.size()) - 1;
}

void Findings::error(Mark where, std::string path, std::string problem) {
  found_.push_back({where, Severity::error, std::move(path), std::move(problem)});
  ++errors_;
}

void Findings::warning(Mark where, std::string path, std::string problem) {
  found_.push_back({where, Severity::warning, std::move(path), std::move(problem)});
}

void Findings::move_to(Diagnostics& out) {
  const auto place = [](const Finding& f) {
    return std::tuple(f.where.source, f.where.line, f.where.column);
  };
  std::stable_sort(
      found_.begin(), found_.end(),
      [&](const Finding& a, const Finding& b) { return place(a) < place(b); });
  const auto key = [](const Finding& f) {
    return f.path.substr(f.path.rfind('.') + 1);
  };
  std::vector<Finding> kept;
  const auto repeats = [&](const Finding& f) {
    if (f.where.line == 0) return false;
    // Against all at its place: what several keys say of one anchor comes mixed.
    for (auto k = kept.rbegin(); k != kept.rend() && place(*k) == place(f); ++k)
      if (k->problem == f.problem && key(*k) == key(f)) return true;
    return false;
  };
  for (Finding& f : found_)
    if (!repeats(f)) kept.push_back(std::move(f));
  for (Finding& f : kept)
    out.push_back({{sources_[static_cast<std::size_t>(f.where.source)], f.where.line,
                    f.where.column},
                   f.severity,
                   (f.path.empty() ? "" : f.path + ": ") + f.problem});
  found_.clear();
}

}  // namespace delos
