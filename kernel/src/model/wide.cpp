#include "delos/model/wide.h"

#include <algorithm>
#include <cstdlib>
#include <string_view>

namespace delos {
namespace {

VectorWidth of_processor() {
#if defined(__x86_64__) && defined(__GNUC__)
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512vl"))
    return VectorWidth::avx512;
  if (__builtin_cpu_supports("avx2")) return VectorWidth::avx2;
#endif
  return VectorWidth::baseline;
}

VectorWidth wanted() {
  const char* const said = std::getenv("DELOS_VECTORS");
  const std::string_view word = said ? said : "";
  if (word == "baseline") return VectorWidth::baseline;
  return word == "avx2" ? VectorWidth::avx2 : VectorWidth::avx512;
}

}  // namespace

VectorWidth vector_width() {
  static const VectorWidth width = std::min(of_processor(), wanted());
  return width;
}

}  // namespace delos
