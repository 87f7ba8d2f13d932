// Loops over lanes in the widest vectors that the processor has.
#pragma once

#include <cstdint>

#include "delos/api.h"

namespace delos {

/// Vectors that a loop can be compiled for.
enum class VectorWidth : std::uint8_t { baseline, avx2, avx512 };

/// The widest that this processor has, or, where that is less, what the environment's
/// DELOS_VECTORS says: baseline, avx2 or avx512.
[[nodiscard]] DELOS_API VectorWidth vector_width();

/// A body compiled for one width, all that it calls inlined: compilers make vector
/// instructions of loops without calls only.
template <class Body>
[[gnu::flatten, gnu::noinline]] void in_baseline(const Body& body) {
  body();
}

#if defined(__x86_64__) && defined(__GNUC__)

template <class Body>
[[gnu::flatten, gnu::noinline, gnu::target("avx2")]] void in_avx2(const Body& body) {
  body();
}
template <class Body>
[[gnu::flatten, gnu::noinline,
  gnu::target("avx512f,avx512dq,avx512vl,prefer-vector-width=512")]] void
in_avx512(const Body& body) {
  body();
}

/// Run a body of loops over lanes. No operation is fused, so that it gives the same
/// bytes in every width.
template <class Body>
void in_wide_vectors(const Body& body) {
  switch (vector_width()) {
    case VectorWidth::avx512:
      return in_avx512(body);
    case VectorWidth::avx2:
      return in_avx2(body);
    case VectorWidth::baseline:
      return in_baseline(body);
  }
}

#else

template <class Body>
void in_wide_vectors(const Body& body) {
  in_baseline(body);
}

#endif

}  // namespace delos
