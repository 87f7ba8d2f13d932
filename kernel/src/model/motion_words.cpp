#include "delos/model/motion_words.h"

#include <array>
#include <numbers>

namespace delos {
namespace {

NamedMotion in_words(const char* name, const char* what, int order,
                     const MotionWords& words, const char* source) {
  return {name, what, order, q_of(words, order), source, true};
}

std::array<NamedMotion, 8> all_motions() {
  // 1.27 m, half of the way accelerated and half slowed down, in 0.35 s.
  const double punch_time = 0.35 / 2, punch = 1.27 / (punch_time * punch_time);
  return {{
      in_words("still", "something put down, which creeps", 1, {1e-3, 1.0},
               "1 mm/s in any direction, forgotten within 1 s: assumed"),
      in_words(
          "walk", "a person walks about", 2, {1.4, 1.0, 0.2},
          "1.4 m/s: comfortable gait, R. W. Bohannon, Age and Ageing 26(1), 15-19, "
          "1997; turns within 1 s, bobs at 0.2 m/s: assumed"),
      in_words("run", "a person runs about", 2, {4.0, 0.5, 0.8},
               "4 m/s, turns within 0.5 s, bobs at 0.8 m/s: assumed"),
      {"hiball_head",
       "a head with a HiBall",
       2,
       {0.261782402027 * 0.261782402027, 0.261782402027 * 0.261782402027,
        0.0815344167 * 0.0815344167},
       "B. D. Allen, dissertation, 2007, Eq. 57, after the HiBall's software",
       false},
      {"acoustic_wand",
       "a wand among acoustic beacons",
       2,
       {0.3951529079, 0.3951529079, 0.10745377401},
       "B. D. Allen, dissertation, 2007, Fig. 4.5",
       false},
      in_words("led_arm", "an LED on an arm of 15 cm, a turn in 10 s", 2,
               {0.15 * 2 * std::numbers::pi / 10, 10 / (2 * std::numbers::pi)},
               "G. Welch and others, 2007, section 4; forgotten in a radian: assumed"),
      {"reach",
       "a wrist that reaches for a box",
       3,
       {7.17, 7.17, 2.29},
       "delos fit-motion of pyomeca's markers.trc, WRIST, every 10 ms: x and z as "
       "found, y as x",
       false},
      in_words(
          "punch", "a boxer's fist", 3, {punch, punch_time},
          "50 in: B. D. Allen, dissertation, 2007, section 3.3.2; in 0.35 s, there "
          "accelerated and slowed down evenly: assumed"),
  }};
}

}  // namespace

Eigen::Vector3d q_of(const MotionWords& words, int order) {
  const double square = words.fast * words.fast;
  Eigen::Vector3d variance = Eigen::Vector3d::Constant(square / 3);
  if (words.vertical)
    variance = {square / 2, square / 2, *words.vertical * *words.vertical};
  return order == 1 ? Eigen::Vector3d(2 * words.within * variance)
                    : Eigen::Vector3d(2 / words.within * variance);
}

std::span<const NamedMotion> named_motions() {
  static const std::array<NamedMotion, 8> all = all_motions();
  return all;
}

const NamedMotion* named_motion(const std::string& name) {
  for (const NamedMotion& motion : named_motions())
    if (name == motion.name) return &motion;
  return nullptr;
}

}  // namespace delos
