// What a covariance is of: numbers of scenes can be compared where this is the same.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "delos/api.h"
#include "delos/model/metric.h"
#include "delos/scene/scene.h"

namespace delos {

/// Which covariance is computed.
struct Definition {
  Fusion fusion = Fusion::stacked;
  CovarianceKind covariance = CovarianceKind::prior;
  double lag = 0;  ///< seconds later
  /// The part of the error, where some device says how well it is known.
  std::optional<ErrorPart> error = {};
  friend bool operator==(const Definition&, const Definition&) = default;
};

/// The state of a device's clock, "clock_NAME"; empty where it has none.
[[nodiscard]] DELOS_API std::string clock_state(const DeviceEntry& device);

/// What a scene says of how a clock drifts; null: nothing, it is unknown anew at each
/// update.
[[nodiscard]] DELOS_API const ClockEntry* clock_entry(const Scene& scene,
                                                      const std::string& clock);

/// Whether a device has a share in errors that are common.
[[nodiscard]] DELOS_API bool shares_error(const CommonError& common,
                                          const DeviceEntry& device);

/// Whether devices have constant errors: of calibration, or of readings without sight.
[[nodiscard]] DELOS_API bool has_constant_errors(const Scene& scene);

/// Empty where constant errors of calibration can be told what they do; else why not, a
/// sentence without its subject.
[[nodiscard]] DELOS_API std::string calibration_problem(const MotionModel& motion,
                                                        const Definition& definition);

/// Empty where clocks may be unknown anew at each update; else why not, a sentence
/// without its subject.
[[nodiscard]] DELOS_API std::string free_clock_problem(const Definition& definition);

/// The states that a scene's covariance has: of a single reading, those of the pose and
/// of the clocks.
[[nodiscard]] DELOS_API StateLayout covariance_layout(const Scene& scene);

/// The metrics that a scene can name: those of its states, and its own.
[[nodiscard]] DELOS_API KnownMetrics known_metrics(const Scene& scene);

/// "a-priori covariance, stacked fusion", "a-posteriori covariance 20 ms later, stacked
/// fusion", "covariance of a single reading"
[[nodiscard]] DELOS_API std::string to_string(const Definition& definition);

/// Whether numbers of both can be compared: continuous and periodic fusion know no
/// difference between before an update and after it.
[[nodiscard]] DELOS_API bool alike(const Definition& a, const Definition& b);

/// Whether a variable changes the rate of a device.
[[nodiscard]] DELOS_API bool varies_rates(const Scene& scene);

/// Whether a variable changes how long a device exposes.
[[nodiscard]] DELOS_API bool varies_exposures(const Scene& scene);

/// Whether all devices have one rate, whatever the variables are set to.
[[nodiscard]] DELOS_API bool has_one_rate(const Scene& scene);

/// Updates a second: as given, or by the device's timing.
[[nodiscard]] DELOS_API double rate_of(const DeviceEntry& device);

/// Empty where a device's noise at its exposure is known; else a phrase about the
/// exposure.
[[nodiscard]] DELOS_API std::string noise_problem(const DeviceEntry& device);

/// Empty where what is fused so can be carried on for a lag; else why not, a sentence
/// without its subject.
[[nodiscard]] DELOS_API std::string lag_problem(const MotionModel& motion,
                                                const Definition& definition);

/// Empty where a device's reading is over by its next update; else a phrase about its
/// exposure.
/// @pre its rate is above 0
[[nodiscard]] DELOS_API std::string exposure_problem(const DeviceEntry& device);

/// Empty where readings that are fused so can take time; else why not, a sentence
/// without its subject.
[[nodiscard]] DELOS_API std::string exposure_problem(const MotionModel& motion,
                                                     const Definition& definition);

/// What a scene's numbers are of. Its fusion, where it doesn't say, is its default:
/// stacked where has_one_rate(), or motion is one update, else continuous. So no design
/// of a search has another definition than the scene that it began with.
/// A single reading has all devices read once, together, whatever their rates: stacked.
[[nodiscard]] DELOS_API Definition definition_of(const Scene& scene);

/// The scene with its fusion written down, so that parts and copies of it keep it; but
/// for single readings, which have none.
[[nodiscard]] DELOS_API Scene with_definition(Scene scene);

/// The one fusion under which scenes are compared. A scene that says another one than
/// its default demands it; all that do must agree. Where none does: stacked if that is
/// every scene's default, else continuous.
/// @returns nullopt where they demand different ones, or one can't have what others
///          demand
/// @pre there is a scene
[[nodiscard]] DELOS_API std::optional<Fusion> common_fusion(
    std::span<const Scene* const> scenes);

}  // namespace delos
