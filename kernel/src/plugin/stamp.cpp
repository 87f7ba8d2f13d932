#include <array>
#include <string>

#include "delos/plugin/registry.h"

namespace delos {
namespace {

struct StampField {
  std::uint32_t AbiStamp::*value;
  const char* what;    ///< what differs, for people
  const char* source;  ///< where the number comes from, for searching
  const char* remedy;
};

constexpr const char* kHeaders = "rebuild it with the kernel's headers";
constexpr const char* kCompiler = "rebuild it with the kernel's compiler";
constexpr const char* kFlags = "rebuild it with the kernel's headers and flags";

// In order of reading: where an earlier field differs, a later one may not be there.
constexpr std::array kFields = {
    StampField{&AbiStamp::bytes, "another plugin stamp", "sizeof(AbiStamp)", kHeaders},
    StampField{&AbiStamp::epoch, "another plugin contract", "kAbiEpoch", kHeaders},
    StampField{&AbiStamp::cxx_abi, "another C++ ABI", "__GXX_ABI_VERSION", kCompiler},
    StampField{&AbiStamp::libstdcxx, "another libstdc++ mode",
               "_GLIBCXX_USE_CXX11_ABI + 2 _GLIBCXX_DEBUG",
               "rebuild it with the kernel's -D_GLIBCXX flags"},
    StampField{&AbiStamp::eigen, "another Eigen", "version",
               "rebuild it with that Eigen"},
    StampField{&AbiStamp::eigen_align, "other -m flags", "EIGEN_MAX_ALIGN_BYTES",
               nullptr},
    StampField{&AbiStamp::target, "another Target", "sizeof(Target)", kFlags},
    StampField{&AbiStamp::observation, "another Observation", "sizeof(Observation)",
               kFlags},
    StampField{&AbiStamp::param_spec, "another ParamSpec", "sizeof(ParamSpec)", kFlags},
    StampField{&AbiStamp::lanes, "another number of lanes", "kLanes", kHeaders},
    StampField{&AbiStamp::point_lanes, "another PointLanes", "sizeof(PointLanes)",
               kFlags},
    StampField{&AbiStamp::row_lanes, "another RowLanes", "sizeof(RowLanes)", kFlags},
    StampField{&AbiStamp::beacon_lanes, "another BeaconLanes", "sizeof(BeaconLanes)",
               kFlags},
    StampField{&AbiStamp::smooth_rows, "another SmoothRows", "sizeof(SmoothRows)",
               kFlags},
    StampField{&AbiStamp::view_cone, "another ViewCone", "sizeof(ViewCone)", kFlags},
    StampField{&AbiStamp::own_state, "another OwnState", "sizeof(OwnState)", kFlags},
};

static_assert(sizeof(AbiStamp) == kFields.size() * sizeof(std::uint32_t),
              "every field of the stamp is compared");

}  // namespace

std::string stamp_difference(const AbiStamp& plugin) {
  constexpr AbiStamp kernel = this_abi();
  for (const StampField& f : kFields) {
    const std::uint32_t theirs = plugin.*f.value;
    const std::uint32_t ours = kernel.*f.value;
    if (theirs == ours) continue;
    // Only alignment says which side has the flag: vector instructions raise it.
    const char* remedy = f.remedy        ? f.remedy
                         : theirs > ours ? "rebuild it without -march/-mavx"
                                         : "rebuild it with the kernel's -march/-mavx";
    return std::string("was built with ") + f.what + " (" + f.source + " " +
           std::to_string(theirs) + ", the kernel has " + std::to_string(ours) + "); " +
           remedy;
  }
  return {};
}

}  // namespace delos
