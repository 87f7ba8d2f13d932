// Spectral forms of neighbouring poses.
#include <cmath>
#include <limits>

#include "delos/riccati/spectral.h"
#include "riccati/directions.h"
#include "riccati/dispatch.h"
#include "riccati/jacobi.h"

namespace delos {
namespace {

using riccati::fixed;
using riccati::JacobiResult;
using riccati::Square;

template <int kSize>
void reduce_block(const CoordinateMatrix& L, const double* packed, std::size_t stride,
                  std::span<SpectralForm> forms) {
  constexpr double kEps = std::numeric_limits<double>::epsilon();
  const Square<kSize> factor = fixed<kSize>(L);
  // λ and V = L U of the pose before; M = Vᵀ S V is nearly diagonal already. Rotations
  // keep V within 64·ε of L times an orthogonal matrix over a block.
  JacobiResult<kSize> r;
  r.U = factor;
  for (std::size_t l = 0; l < forms.size(); ++l) {
    Square<kSize> S;
    const double* element = packed + l;
    for (int i = 0; i < kSize; ++i) {
      for (int j = 0; j <= i; ++j, element += stride) S(i, j) = S(j, i) = *element;
    }
    Square<kSize> M = r.U.transpose() * (S * r.U).eval();
    riccati::jacobi_diagonalize<kSize>(M, r.U);
    r.lambda = M.diagonal();
    riccati::sort_ascending(r);

    SpectralForm& form = forms[l];
    form.lambda = r.lambda;
    form.LU = r.U;
    form.unobservable = 0;
    const double least = 16 * kSize * kEps * r.lambda[kSize - 1];
    // "not above" also takes S = 0, and a matrix of NaNs.
    while (form.unobservable < kSize && !(form.lambda[form.unobservable] > least)) {
      form.lambda[form.unobservable++] = 0;
    }
    if (!r.U.allFinite()) r.U = factor;
  }
}

}  // namespace

void spectral_forms(const CoordinateMatrix& L, const double* packed, std::size_t stride,
                    std::span<SpectralForm> forms) {
  riccati::with_coordinates(
      L.rows(), [&]<int kSize>() { reduce_block<kSize>(L, packed, stride, forms); });
}

}  // namespace delos
