#include "motion/segments.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "delos/text/format.h"

namespace delos::motion {
namespace {

/// No part is shorter: fewer frames tell little of six numbers.
constexpr int kShortest = 2 * kFewestFrames;
/// Places of a cut that are tried before the best is looked at more closely.
constexpr int kPlaces = 16;

class Cutter {
 public:
  Cutter(const recordings::Track& track, double period, const FitQuestion& question)
      : track_(track), period_(period), question_(question) {}

  /// Of the frames that count: a part by their numbers. Nothing where it has no fit.
  [[nodiscard]] std::optional<Segment> part(int begin, int end, double dt) const {
    FitQuestion of = question_;
    of.from = question_.from + begin * dt;
    of.to = question_.from + end * dt;
    auto answer = fit_motion(track_, period_, of);
    auto* fit = std::get_if<MotionFit>(&answer);
    if (!fit) return std::nullopt;
    return Segment{of.from, *of.to, std::move(*fit)};
  }

 private:
  const recordings::Track& track_;
  double period_;
  const FitQuestion& question_;
};

/// BIC of a part. No likelihood counts the innovations that find the state, so that
/// parts would be shorter for being many: they are taken to be as long as the others.
double length_of(const std::optional<Segment>& segment) {
  if (!segment) return INFINITY;
  const MotionFit& fit = segment->fit;
  const double seen = static_cast<double>(fit.frames - fit.gaps);
  const double numbers = 6 * std::log(3 * seen);
  const double of_data =
      fit.orders[static_cast<std::size_t>(fit.likeliest)].bayes - numbers;
  return of_data * seen / (seen - kOrders) + numbers;
}

struct Numbered {
  int begin, end;
  Segment segment;
};

/// Cut [begin, end) into the parts that are shortest to describe.
void cut(const Cutter& cutter, const Numbered& whole, double dt, double price,
         std::vector<Numbered>& out) {
  const int first = whole.begin + kShortest, last = whole.end - kShortest;
  if (first > last) return out.push_back(whole);
  std::optional<Segment> left, right;
  double least = length_of(whole.segment) - price;
  int best = -1;
  const auto consider = [&](int at) {
    if (at < first || at > last) return;
    auto a = cutter.part(whole.begin, at, dt), b = cutter.part(at, whole.end, dt);
    const double length = length_of(a) + length_of(b);
    if (!(length < least)) return;
    least = length;
    best = at;
    left = std::move(a);
    right = std::move(b);
  };
  int step = std::max(1, (last - first) / kPlaces);
  for (int at = first; at <= last; at += step) consider(at);
  if (best < 0) return out.push_back(whole);
  for (step /= 2; step > 0; step /= 2) {
    const int about = best;
    consider(about - step);
    consider(about + step);
  }
  cut(cutter, {whole.begin, best, std::move(*left)}, dt, price, out);
  cut(cutter, {best, whole.end, std::move(*right)}, dt, price, out);
}

/// Join neighbours that are shorter as one.
void join(const Cutter& cutter, double dt, double price, std::vector<Numbered>& parts) {
  for (std::size_t i = 0; i + 1 < parts.size();) {
    auto both = cutter.part(parts[i].begin, parts[i + 1].end, dt);
    if (length_of(both) - price >
        length_of(parts[i].segment) + length_of(parts[i + 1].segment)) {
      ++i;
      continue;
    }
    parts[i] = {parts[i].begin, parts[i + 1].end, std::move(*both)};
    parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(i) + 1);
  }
}

}  // namespace

std::variant<std::vector<Segment>, std::string> fit_segments(
    const recordings::Track& track, double period, const FitQuestion& question) {
  auto answer = fit_motion(track, period, question);
  if (auto* problem = std::get_if<std::string>(&answer)) return std::move(*problem);
  auto& fit = std::get<MotionFit>(answer);
  const int frames = static_cast<int>(fit.frames);
  const double dt = fit.dt, price = std::log(3.0 * frames);
  const Cutter cutter(track, period, question);
  std::vector<Numbered> parts;
  cut(cutter, {0, frames, {question.from, question.from + frames * dt, std::move(fit)}},
      dt, price, parts);
  join(cutter, dt, price, parts);
  std::vector<Segment> segments;
  for (Numbered& part : parts) segments.push_back(std::move(part.segment));
  return segments;
}

std::string motions_block(const std::vector<Segment>& segments,
                          const std::string& source) {
  std::string text = "motions:\n";
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Segment& s = segments[i];
    std::string block =
        motion_block(s.fit, source + ", " + format_quantity(s.from, "s") + " to " +
                                format_quantity(s.to, "s"));
    block.replace(0, std::string("motion").size(), "part" + std::to_string(i + 1));
    for (std::size_t at = 0; at < block.size(); at = block.find('\n', at) + 1)
      block.insert(at, "  ");
    text += block;
  }
  return text;
}

}  // namespace delos::motion
