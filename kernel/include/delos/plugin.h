// All that a device plugin includes.
#pragma once

#include <cstdint>
#include <iterator>

#include "delos/device/device.h"
#include "delos/device/parameters.h"

namespace delos {

/// Raised by one whenever a type in this contract changes shape or meaning.
inline constexpr std::uint32_t kAbiEpoch = 10;

/// What two binaries must agree on before a C++ object may pass between them.
/// Fixed-width fields only; new ones go at the end; the first two never move.
struct AbiStamp {
  std::uint32_t bytes;         ///< sizeof(AbiStamp) as the plugin saw it
  std::uint32_t epoch;         ///< kAbiEpoch
  std::uint32_t cxx_abi;       ///< __GXX_ABI_VERSION
  std::uint32_t libstdcxx;     ///< dual-ABI and debug-mode switches
  std::uint32_t eigen;         ///< Eigen version, 3.4.0 → 30400
  std::uint32_t eigen_align;   ///< EIGEN_MAX_ALIGN_BYTES: -march=native moves it
  std::uint32_t target;        ///< sizeof(Target)
  std::uint32_t observation;   ///< sizeof(Observation)
  std::uint32_t param_spec;    ///< sizeof(ParamSpec)
  std::uint32_t lanes;         ///< kLanes
  std::uint32_t point_lanes;   ///< sizeof(PointLanes)
  std::uint32_t row_lanes;     ///< sizeof(RowLanes)
  std::uint32_t beacon_lanes;  ///< sizeof(BeaconLanes)
  std::uint32_t smooth_rows;   ///< sizeof(SmoothRows)
  std::uint32_t view_cone;     ///< sizeof(ViewCone)
  std::uint32_t own_state;     ///< sizeof(OwnState)
};

/// The stamp of whichever binary this header is compiled into.
constexpr AbiStamp this_abi() {
  std::uint32_t libstdcxx = _GLIBCXX_USE_CXX11_ABI;
#ifdef _GLIBCXX_DEBUG
  libstdcxx |= 2u;
#endif
  return {sizeof(AbiStamp),
          kAbiEpoch,
          __GXX_ABI_VERSION,
          libstdcxx,
          EIGEN_WORLD_VERSION * 10000 + EIGEN_MAJOR_VERSION * 100 + EIGEN_MINOR_VERSION,
          EIGEN_MAX_ALIGN_BYTES,
          sizeof(Target),
          sizeof(Observation),
          sizeof(ParamSpec),
          kLanes,
          sizeof(PointLanes),
          sizeof(RowLanes),
          sizeof(BeaconLanes),
          sizeof(SmoothRows),
          sizeof(ViewCone),
          sizeof(OwnState)};
}

/// What a plugin library says of itself. Static storage, owned by the plugin.
struct PluginInfo {
  AbiStamp abi;    ///< First, always: checked before all else.
  const char* id;  ///< snake_case: the `type:` of a scene entry and the file's name
  const char* version;      ///< MAJOR.MINOR.PATCH of this plugin
  const char* summary;      ///< one sentence
  const ParamSpec* params;  ///< n_params rows
  std::uint32_t n_params;
  Device* (*create)(
      const ParamValues&);  ///< may throw std::exception: values that clash
  void (*destroy)(Device*);
};

}  // namespace delos

/// Closes a device plugin. Class needs a static constexpr array kParams of ParamSpec
/// and a constructor from delos::ParamValues.
#define DELOS_DEVICE_PLUGIN(Class, Id, Version, Summary)                            \
  extern "C" DELOS_API const delos::PluginInfo* delos_plugin() {                    \
    static constexpr delos::PluginInfo info{                                        \
        delos::this_abi(),                                                          \
        Id,                                                                         \
        Version,                                                                    \
        Summary,                                                                    \
        Class::kParams,                                                             \
        static_cast<std::uint32_t>(std::size(Class::kParams)),                      \
        [](const delos::ParamValues& p) -> delos::Device* { return new Class(p); }, \
        [](delos::Device* d) { delete d; }};                                        \
    return &info;                                                                   \
  }                                                                                 \
  static_assert(true, "swallow the semicolon")
