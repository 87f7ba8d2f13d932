// SLICOT's Riccati solvers, called as Fortran.
#pragma once

#include <Eigen/Core>
#include <vector>

extern "C" {
// Discrete or continuous, by QZ on the extended pencil. SLICOT 5.0, SB02OD.html.
void sb02od_(const char* dico, const char* jobb, const char* fact, const char* uplo,
             const char* jobl, const char* sort, const int* n, const int* m,
             const int* p, const double* a, const int* lda, const double* b,
             const int* ldb, const double* q, const int* ldq, const double* r,
             const int* ldr, const double* l, const int* ldl, double* rcond, double* x,
             const int* ldx, double* alfar, double* alfai, double* beta, double* s,
             const int* lds, double* t, const int* ldt, double* u, const int* ldu,
             const double* tol, int* iwork, double* dwork, const int* ldwork,
             int* bwork, int* info);
// Discrete or continuous, by the Schur form of the symplectic or Hamiltonian matrix.
void sb02md_(const char* dico, const char* hinv, const char* uplo, const char* scal,
             const char* sort, const int* n, double* a, const int* lda, const double* g,
             const int* ldg, double* q, const int* ldq, double* rcond, double* wr,
             double* wi, double* s, const int* lds, double* u, const int* ldu,
             int* iwork, double* dwork, const int* ldwork, int* bwork, int* info);
}

namespace delos::testing {

struct SlicotResult {
  Eigen::MatrixXd P;
  double rcond = 0;  ///< of the linear system that P comes from, as SLICOT estimates it
  int info = -1;     ///< 0: solved
};

/// Work space kept between calls, so that a benchmark times the solver only.
class Slicot {
 public:
  explicit Slicot(int n)
      : n_(n),
        n2_(2 * n),
        ldwork_(64 * n + 256),
        work_(ldwork_),
        alfar_(n2_),
        alfai_(n2_),
        beta_(n2_),
        s_(n2_ * n2_),
        t_(n2_ * n2_),
        u_(n2_ * n2_),
        iwork_(n2_),
        bwork_(n2_) {}

  /// P∞ of x⁺ = A x + w with information S per update (discrete), or of dx/dt = A x + w
  /// with information rate S: the control equation for Aᵀ.
  SlicotResult sb02od(const Eigen::MatrixXd& A, const Eigen::MatrixXd& Q,
                      const Eigen::MatrixXd& S, bool continuous = false) {
    const Eigen::MatrixXd At = A.transpose();
    SlicotResult result{Eigen::MatrixXd(n_, n_)};
    const int zero = 0, one = 1;
    const double tol = 0, unused = 0;
    sb02od_(continuous ? "C" : "D", "G", "N", "U", "Z", "S", &n_, &zero, &zero,
            At.data(), &n_, S.data(), &n_, Q.data(), &n_, &unused, &one, &unused, &one,
            &result.rcond, result.P.data(), &n_, alfar_.data(), alfai_.data(),
            beta_.data(), s_.data(), &n2_, t_.data(), &n2_, u_.data(), &n2_, &tol,
            iwork_.data(), work_.data(), &ldwork_, bwork_.data(), &result.info);
    return result;
  }

  SlicotResult sb02md(const Eigen::MatrixXd& A, const Eigen::MatrixXd& Q,
                      const Eigen::MatrixXd& S) {
    Eigen::MatrixXd At = A.transpose();
    SlicotResult result{Q};
    sb02md_("D", "D", "U", "N", "U", &n_, At.data(), &n_, S.data(), &n_,
            result.P.data(), &n_, &result.rcond, alfar_.data(), alfai_.data(),
            s_.data(), &n2_, u_.data(), &n2_, iwork_.data(), work_.data(), &ldwork_,
            bwork_.data(), &result.info);
    return result;
  }

 private:
  int n_, n2_, ldwork_;
  std::vector<double> work_, alfar_, alfai_, beta_, s_, t_, u_;
  std::vector<int> iwork_, bwork_;
};

}  // namespace delos::testing
