// Readings that take time: what they are the means of, as states beside the motion's.
#pragma once

#include <span>
#include <vector>

#include "delos/rig/schedule.h"
#include "delos/steady/equation.h"

namespace delos {

/// The windows over which the devices of a cycle expose, and the motion with them.
///
/// While a reading is under way, d states behind those of the motion hold what it is
/// going to be of, the integral so far over its window's length τ, which at the update
/// is the mean of the pose. Between two instants with the same windows open, the chain
/// of order k with its integral I is a chain of order k + 1,
///
///     [I, x]⁺ = A_{k+1}(δ) [0, x] + w,  w ~ N(0, Q_{k+1}(δ)),   m⁺ = m + I/τ
///
/// so that means, and whatever they share of the noise, are exact. Readings of one
/// window share its states, and windows that don't overlap take turns.
class ExposureWindows {
 public:
  /// @throws std::invalid_argument more windows overlap than a state holds
  ExposureWindows(const System& system, std::span<const UpdateSlot> slots);

  /// The motion that leads to a slot: discretize(), and the means of open windows.
  [[nodiscard]] MotionStep motion(std::size_t slot) const;
  /// What a device reads at a slot at which it reports.
  [[nodiscard]] StateBlock block(std::size_t slot, int device) const;

 private:
  /// What a window covers of the time that leads to a slot: its end.
  struct Part {
    std::size_t end;  // the slot at which it is read
    int channel;      // which d states
    double exposure;  // τ, seconds
    double open;      // seconds
    bool begun;       // before
  };

  void add(std::size_t slot, double exposure);
  [[nodiscard]] std::vector<Part> parts_of(std::size_t slot, double exposure) const;
  [[nodiscard]] const Part* find(std::size_t slot, double exposure) const;
  /// The motion that leads to a slot, its readings being of that instant with a motion
  /// of their own: the papers' approximations.
  [[nodiscard]] MotionStep approximate_motion(std::size_t slot) const;
  /// The motion over δ seconds in which the windows of some parts are open.
  [[nodiscard]] MotionStep motion_within(double delta,
                                         std::span<const Part> open) const;

  const System& system_;
  std::vector<double> intervals_;
  std::vector<std::vector<Part>> parts_;  // of each slot
  int states_ = 0;                        // n and d for each channel
};

}  // namespace delos
