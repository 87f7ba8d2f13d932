// A range sensor that misbehaves as it is told to: in its constructor from a knob of 1
// on, or in what it answers through one of its entries.
#include <delos/device/range_device.h>
#include <delos/plugin.h>

#include <cmath>
#include <limits>
#include <new>
#include <stdexcept>

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

void fail(const std::string& how) {
  if (how == "throws") throw std::runtime_error("the lens is dirty");
  if (how == "silent") throw std::runtime_error("");
  if (how == "number") throw 42;
  if (how == "memory") throw std::bad_alloc();
}

class Faulty final : public delos::RangeDevice {
 public:
  static constexpr delos::ParamSpec kParams[] = {
      {.name = "knob", .initial = 0, .lower = 0, .upper = 2, .help = "1: can't be."},
      {.name = "create",
       .kind = delos::ParamKind::choice,
       .text = "sound",
       .choices = "sound|throws|silent|number|memory",
       .help = "What its constructor does."},
      {.name = "answer",
       .kind = delos::ParamKind::choice,
       .text = "sound",
       .choices = "sound|nan|negative|large_R|narrow_H|small_R|asymmetric|indefinite|"
                  "wild_H|infinite_R|throws|silent|number|memory|rows",
       .help = "What it answers."},
      {.name = "entry",
       .kind = delos::ParamKind::choice,
       .text = "single",
       .choices = "single|lanes|smooth",
       .help = "The entry that does."},
  };

  explicit Faulty(const delos::ParamValues& p)
      : RangeDevice(1e-4, 0, 100),
        answer_(p.choice("answer")),
        entry_(p.choice("entry")) {
    if (p["knob"] >= 1) fail(p.choice("create"));
  }

  bool observe(const delos::Target& target, delos::Observation& out) const override {
    if (!RangeDevice::observe(target, out)) return false;
    if (entry_ != "single") return true;
    fail(answer_);
    if (answer_ == "nan") out.R(0, 0) = kNan;
    if (answer_ == "negative") out.R(0, 0) = -1e-4;
    if (answer_ == "infinite_R") out.R(0, 0) = std::numeric_limits<double>::infinity();
    if (answer_ == "large_R") out.R.setIdentity(2, 2);
    if (answer_ == "narrow_H") out.H.setOnes(1, 2);
    if (answer_ == "small_R") out.H.setOnes(2, 3);
    if (answer_ == "wild_H") out.H(0, 1) = kNan;
    if (answer_ == "asymmetric" || answer_ == "indefinite") {
      out.H.setOnes(2, 3);
      out.R.setIdentity(2, 2);
      out.R(0, 1) = answer_ == "indefinite" ? 2 : 0.5;
      out.R(1, 0) = answer_ == "indefinite" ? 2 : 0;
    }
    return true;
  }

  bool observe_lanes(const delos::PointLanes& points,
                     delos::RowLanes& out) const override {
    if (entry_ == "single") return false;
    return RangeDevice::observe_lanes(points, out) && spoiled(out);
  }

  bool observe_view_lanes(int, const delos::BeaconLanes& beacons,
                          delos::RowLanes& out) const override {
    if (entry_ == "single") return false;
    delos::PointLanes points;
    points.count = beacons.count;
    for (int i = 0; i < 3; ++i)
      for (int l = 0; l < delos::kLanes; ++l) points.p[i][l] = beacons.p[i][l];
    return RangeDevice::observe_lanes(points, out) && spoiled(out);
  }

  bool observe_smoothly(const Eigen::Vector3d& p,
                        delos::SmoothRows& out) const override {
    if (!RangeDevice::observe_smoothly(p, out)) return false;
    if (entry_ != "smooth") return true;
    fail(answer_);
    if (answer_ == "nan") out.variance(0) = kNan;
    if (answer_ == "wild_H") out.H(0, 1) = kNan;
    if (answer_ == "rows") out.rows = 4;
    return true;
  }

 private:
  bool spoiled(delos::RowLanes& out) const {
    if (entry_ != "lanes") return true;
    fail(answer_);
    if (answer_ == "nan") out.variance[0][0] = kNan;
    if (answer_ == "negative") out.variance[0][0] = -1e-4;
    if (answer_ == "wild_H") out.H[0][1][0] = kNan;
    if (answer_ == "rows") out.rows = 4;
    return true;
  }

  std::string answer_, entry_;
};

}  // namespace

DELOS_DEVICE_PLUGIN(Faulty, "faulty", "1.0.0", "Misbehaves.");
