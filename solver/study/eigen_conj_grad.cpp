#include "solver/study/history.h"

#include <Eigen/Core>
#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
#include <algorithm>

// Eigen's protocol for matrices that are given only by their products ("Matrix-free solvers" in its
// documentation).
namespace {
class Operator;
}

namespace Eigen::internal {
template <>
struct traits<Operator> : traits<SparseMatrix<double>> {};
}  // namespace Eigen::internal

namespace {

class Operator : public Eigen::EigenBase<Operator> {
 public:
  using Scalar = double;
  using RealScalar = double;
  using StorageIndex = int;
  enum { ColsAtCompileTime = Eigen::Dynamic, MaxColsAtCompileTime = Eigen::Dynamic, IsRowMajor = false };

  Operator(int n, implicitMatrix* A) : n_(n), A_(A) {}
  Eigen::Index rows() const { return n_; }
  Eigen::Index cols() const { return n_; }
  implicitMatrix* matrix() const { return A_; }

  template <class X>
  Eigen::Product<Operator, X, Eigen::AliasFreeProduct> operator*(const Eigen::MatrixBase<X>& x) const {
    return {*this, x.derived()};
  }

 private:
  int n_;
  implicitMatrix* A_;
};

}  // namespace

// The documentation's version clears the destination and adds the product to it. This one overwrites it.
template <class X>
struct Eigen::internal::generic_product_impl<Operator, X, Eigen::SparseShape, Eigen::DenseShape,
                                             Eigen::GemvProduct> {
  template <class Destination>
  static void evalTo(Destination& b, const Operator& A, const X& x) {
    A.matrix()->matVecMult(const_cast<double*>(x.data()), b.data());
  }
};

namespace solver::study {

void eigen_conj_grad(int n, implicitMatrix* A, double x[], double b[], double tolerance, int* steps) {
  CountingMatrix counting(*A);
  const Operator matrix(n, &counting);
  Eigen::ConjugateGradient<Operator, Eigen::Lower | Eigen::Upper, Eigen::IdentityPreconditioner> solver(
      matrix);
  solver.setTolerance(tolerance);
  solver.setMaxIterations(*steps);
  const Eigen::Map<Eigen::VectorXd> right(b, n);
  Eigen::Map<Eigen::VectorXd>(x, n) = solver.solveWithGuess(right, right);
  // The number of steps follows from the products, one for the first residual and one each: Eigen reports 0
  // both for no step and for convergence in the first one. With b = 0 it makes no product.
  *steps = static_cast<int>(std::max(0L, counting.count() - 1));
}

}  // namespace solver::study
