// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_HarmonicExtension_h
#define interlume_HarmonicExtension_h

#include "vtkType.h"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

#include <functional>
#include <vector>

namespace interlume
{

struct Tetrahedra;

/**
 * @class   HarmonicExtension
 * @brief   computes unknown values at mesh points from the given values at other mesh points
 *
 * The values are interpolated by the discrete harmonic function. It is linear on each tetrahedron,
 * equals the given values, and minimizes the integral of the squared gradient. This is the linear
 * finite element solution of Laplace's equation, with the three-dimensional version of the matrix
 * of U. Pinkall, K. Polthier, "Computing discrete minimal surfaces and their conjugates",
 * Experimental Mathematics 2(1), 1993. Unlike distance weighting, it respects cavities and concave
 * boundaries.
 *
 * The solver works on deviations from the least-squares linear fit, which is added back afterward.
 * Therefore linear functions are reproduced up to rounding error, independent of the solver's
 * residual. Results are clamped to the range of the given values. For the solver, the linear fit
 * replaces given values that are not finite.
 *
 * The solver is Eigen's conjugate gradient method with a diagonal preconditioner, on one thread.
 */
class HarmonicExtension
{
public:
  /// Sets the mesh, which must outlive this object. The values at points without source points (see
  /// PointSources) are unknown.
  explicit HarmonicExtension(const interlume::Tetrahedra& mesh);

  /// Callback that returns true to cancel. It is called in each iteration.
  std::function<bool()> IsCanceled;

  /// Computes the unknown entries of \a values, which has one entry per point.
  void Extend(std::vector<double>& values) const;

private:
  using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor, Eigen::Index>;

  /// Diagonal preconditioner that calls a function in each iteration.
  struct Preconditioner : Eigen::DiagonalPreconditioner<double>
  {
    std::function<void()> BeforeStep;

    template <typename Right>
    auto solve(const Eigen::MatrixBase<Right>& right) const
    {
      this->BeforeStep();
      return Eigen::DiagonalPreconditioner<double>::solve(right);
    }
  };

  const interlume::Tetrahedra& Mesh;
  std::vector<vtkIdType> Unknowns; ///< points without a source
  std::vector<vtkIdType> Rows;     ///< matrix row of each point; -1 if its value is given
  // Both matrices have a row per unknown value. Stiffness has a column per unknown value, Coupling
  // a column per point.
  Matrix Stiffness;
  Matrix Coupling;
  Eigen::ConjugateGradient<Matrix, Eigen::Lower | Eigen::Upper, Preconditioner> Solver;
};

}

#endif
