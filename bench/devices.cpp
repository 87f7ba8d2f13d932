// Readings written once against the same written by hand: 64 points a call, all in
// view.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "delos/device/range_device.h"

namespace {

using namespace delos;

/// z = ‖p‖, as an author would write it for speed.
class RangeByHand final : public Device {
 public:
  bool observe(const Target&, Observation&) const override { return false; }
  bool observe_lanes(const PointLanes& points, RowLanes& out) const override {
    out.rows = 1;
    for (int l = 0; l < kLanes; ++l) {
      const double x = points.p[0][l], y = points.p[1][l], z = points.p[2][l];
      const double range = std::sqrt(x * x + y * y + z * z);
      out.seen[l] = (range > 0) & (range <= reach_) ? 1 : 0;
      out.H[0][0][l] = x / range;
      out.H[0][1][l] = y / range;
      out.H[0][2][l] = z / range;
      out.variance[0][l] = constant_ + growing_ * range * range;
    }
    return true;
  }

 private:
  double constant_ = 1e-4, growing_ = 1e-3, reach_ = 30;
};

/// A pinhole camera's numbers: metres, and normalised ones.
struct Frustum {
  double near = 0.2, far = 12, u_max = 0.64, v_max = 0.51;
  double constant = 1e-8, growing = 1e-9;
};

/// u = x/z, v = y/z.
class CameraByHand final : public Device {
 public:
  bool observe(const Target&, Observation&) const override { return false; }
  bool observe_lanes(const PointLanes& points, RowLanes& out) const override {
    out.rows = 2;
    for (int l = 0; l < kLanes; ++l) {
      const double x = points.p[0][l], y = points.p[1][l], z = points.p[2][l];
      const double u = x / z, v = y / z;
      const bool seen = (z >= f_.near) & (z <= f_.far) & (std::abs(u) <= f_.u_max) &
                        (std::abs(v) <= f_.v_max);
      out.seen[l] = seen ? 1 : 0;
      out.H[0][0][l] = out.H[1][1][l] = 1 / z;
      out.H[0][1][l] = out.H[1][0][l] = 0;
      out.H[0][2][l] = -u / z;
      out.H[1][2][l] = -v / z;
      out.variance[0][l] = out.variance[1][l] =
          f_.constant + f_.growing * (x * x + y * y + z * z);
    }
    return true;
  }

 private:
  Frustum f_;
};

class CameraOnce final : public PointDevice<CameraOnce, 2> {
 public:
  template <class T>
  void read(const Point<T>& p, Reading<T, 2>& out) const {
    using std::abs, std::min;
    out.z[0] = p.x / p.z;
    out.z[1] = p.y / p.z;
    out.variance[0] = out.variance[1] = f_.constant + f_.growing * squared_norm(p);
    const T side_u = f_.u_max * p.z - abs(p.x), side_v = f_.v_max * p.z - abs(p.y);
    out.inside = min(min(T(p.z - f_.near), T(f_.far - p.z)), min(side_u, side_v));
  }

 private:
  Frustum f_;
};

void ask(benchmark::State& state, const Device& device) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> aside(-1, 1);
  std::vector<PointLanes> points(64);
  for (PointLanes& p : points) {
    p.count = kLanes;
    for (int l = 0; l < kLanes; ++l) {
      p.p[0][l] = aside(random);
      p.p[1][l] = aside(random);
      p.p[2][l] = 3 + aside(random);
    }
  }
  RowLanes rows;
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(device.observe_lanes(points[i++ % 64], rows));
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) * kLanes);
}

BENCHMARK_CAPTURE(ask, range_by_hand, RangeByHand());
BENCHMARK_CAPTURE(ask, range_once, RangeDevice(1e-4, 1e-3, 30));
BENCHMARK_CAPTURE(ask, camera_by_hand, CameraByHand());
BENCHMARK_CAPTURE(ask, camera_once, CameraOnce());

}  // namespace
