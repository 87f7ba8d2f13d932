// How often a motion is found again: tracks that are drawn from chains of known order
// and noise, and what fit_motion() says of them (docs/sample-time.md).
//
//     bench_fit_motion [TRACKS] [FRAMES]
#include <cstdio>
#include <cstdlib>

#include "motion/motion_fit.h"
#include "support/walk.h"

namespace delos::motion {
namespace {

struct Found {
  int order = 0, fits = 0, q = 0, r = 0;
};

Found found_again(int k, int tracks, int frames) {
  constexpr double kDt = 0.01;
  Found found;
  for (int s = 0; s < tracks; ++s) {
    // q over two decades, and what the noise is against a step over four.
    const double q = std::pow(10, (s % 7) / 3.0 - 1);
    const double r = q * std::pow(kDt, 2 * k - 1) * std::pow(10, (s % 9) / 2.0);
    recordings::Track track{"drawn", {}};
    track.at.resize(frames, 3);
    for (int axis = 0; axis < 3; ++axis) {
      test::Walk walk(k, q, r, kDt,
                      static_cast<unsigned>(1'000'000 * k + 3 * s + axis));
      for (int i = 0; i < frames; ++i) track.at(i, axis) = walk.next();
    }
    const auto answer = fit_motion(track, kDt, {});
    const MotionFit& fit = std::get<MotionFit>(answer);
    found.order += fit.best == k - 1;
    found.fits += fit.fits;
    for (const ChainFit& axis : fit.orders[static_cast<std::size_t>(k - 1)].axes) {
      found.q += axis.q.low <= q && q <= axis.q.high;
      found.r += axis.r.low <= r && r <= axis.r.high;
    }
  }
  return found;
}

}  // namespace
}  // namespace delos::motion

int main(int argc, char** argv) {
  const int tracks = argc > 1 ? std::atoi(argv[1]) : 1000,
            frames = argc > 2 ? std::atoi(argv[2]) : 600;
  std::printf("%d tracks of %d frames and three axes each\n", tracks, frames);
  for (int k = 1; k <= 3; ++k) {
    const auto found = delos::motion::found_again(k, tracks, frames);
    const auto percent = [&](int count, int of) { return 100.0 * count / of; };
    std::printf(
        "order %d: found %.1f %%, fits %.1f %%, q within %.2f %%, r within %.2f %%\n",
        k, percent(found.order, tracks), percent(found.fits, tracks),
        percent(found.q, 3 * tracks), percent(found.r, 3 * tracks));
  }
}
