// The words that scenes use for enumerators, each declared once.
#pragma once

#include <cstddef>
#include <utility>

#include "delos/scene/scene.h"

namespace delos {

inline constexpr std::pair<const char*, Fusion> kFusionWords[] = {
    {"stacked", Fusion::stacked},   {"continuous", Fusion::continuous},
    {"periodic", Fusion::periodic}, {"sequential", Fusion::sequential},
    {"artemis", Fusion::artemis},
};

inline constexpr std::pair<const char*, CovarianceKind> kCovarianceWords[] = {
    {"prior", CovarianceKind::prior},
    {"posterior", CovarianceKind::posterior},
    {"single", CovarianceKind::single},
};

inline constexpr std::pair<const char*, ErrorPart> kErrorPartWords[] = {
    {"total", ErrorPart::total},
    {"scatter", ErrorPart::scatter},
    {"bias", ErrorPart::bias},
};

inline constexpr std::pair<const char*, ExposureModel> kExposureModelWords[] = {
    {"exact", ExposureModel::exact},
    {"instantaneous", ExposureModel::instantaneous},
    {"averaged", ExposureModel::averaged},
    {"integrated", ExposureModel::integrated},
};

inline constexpr std::pair<const char*, OrientationRule> kOrientationRuleWords[] = {
    {"worst", OrientationRule::worst},
    {"mean", OrientationRule::mean},
    {"information", OrientationRule::information},
};

inline constexpr std::pair<const char*, Mount> kMountWords[] = {
    {"world", Mount::world},
    {"target", Mount::target},
};

inline constexpr std::pair<const char*, bool> kTruthWords[] = {
    {"yes", true}, {"true", true}, {"no", false}, {"false", false}};

inline constexpr std::pair<const char*, BeaconPattern> kBeaconPatternWords[] = {
    {"full", BeaconPattern::full},
    {"half", BeaconPattern::half},
    {"columns", BeaconPattern::columns},
    {"checkerboard", BeaconPattern::checkerboard},
};

inline constexpr std::pair<const char*, SightingRule> kSightingRuleWords[] = {
    {"all", SightingRule::all},       {"mean", SightingRule::mean},
    {"random", SightingRule::random}, {"nearest", SightingRule::nearest},
    {"best", SightingRule::best},
};

inline constexpr std::pair<const char*, PoseState> kPoseStateWords[] = {
    {"position", PoseState::position},
    {"orientation", PoseState::orientation},
    {"pose", PoseState::pose},
    {"planar", PoseState::planar},
    {"planar_pose", PoseState::planar_pose},
    {"none", PoseState::none},
};

/// The word of an enumerator.
/// @pre the table has it
template <class Enum, std::size_t N>
constexpr const char* word_of(const std::pair<const char*, Enum> (&words)[N],
                              Enum value) {
  std::size_t i = 0;
  while (words[i].second != value) ++i;
  return words[i].first;
}

}  // namespace delos
