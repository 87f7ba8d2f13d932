#include "scene/findings.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace delos {

int Findings::add_source(std::string name) {
  sources_.push_back(std::move(name));
  return static_cast<int>(sources_.size()) - 1;
}

void Findings::error(Mark where, std::string message) {
  found_.push_back({where, std::move(message)});
}

void Findings::move_to(Diagnostics& out) {
  const auto place = [](const Finding& f) {
    return std::tuple(f.where.source, f.where.line, f.where.column);
  };
  std::stable_sort(found_.begin(), found_.end(), [&](const Finding& a, const Finding& b) {
    return place(a) < place(b);
  });
  // An anchor's node is found faulty once at every alias; the text is wrong only once.
  const auto last =
      std::unique(found_.begin(), found_.end(), [&](const Finding& a, const Finding& b) {
        return place(a) == place(b) && a.message == b.message;
      });
  for (auto f = found_.begin(); f != last; ++f)
    out.push_back({{sources_[static_cast<std::size_t>(f->where.source)], f->where.line,
                    f->where.column},
                   Severity::error,
                   std::move(f->message)});
  found_.clear();
}

}  // namespace delos
