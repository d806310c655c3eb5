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
 * @brief   values inside a mesh from those at its other points
 *
 * The unknown values are those of the discrete harmonic function: linear on each tetrahedron, equal
 * to the given values, with the least integral of its squared gradient (linear finite elements for
 * Laplace's equation; the matrix is that of U. Pinkall, K. Polthier, "Computing discrete minimal
 * surfaces and their conjugates", Experimental Mathematics 2(1), 1993, one dimension up). It
 * respects cavities and concave boundaries, as a distance through them would not. A linear function
 * is its own harmonic extension; the least-squares linear part of the given values is taken off
 * first, so that such a function comes out to rounding whatever the solver leaves. Values are kept
 * within the range of those given. A given value that is not finite counts as the linear part
 * there.
 *
 * Solved by Eigen's conjugate gradients with a diagonal preconditioner, by one thread.
 */
class HarmonicExtension
{
public:
  /// Takes a mesh, which must outlive this object. The unknown values are those of its points
  /// without a source.
  explicit HarmonicExtension(const interlume::Tetrahedra& mesh);

  /// A function that is asked between iterations; true stops.
  std::function<bool()> IsCancelled;

  /// Fills in the unknown ones among \a values, which has one for each point.
  void Extend(std::vector<double>& values) const;

private:
  using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor, Eigen::Index>;

  /// The solver's own, with a look at what happens around it.
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
  std::vector<vtkIdType> Unknowns; ///< points
  std::vector<vtkIdType> Rows;     ///< of a point, its row in the matrix; -1 for none
  // Rows are those of unknown values; columns are the same, and all points.
  Matrix Stiffness;
  Matrix Coupling;
  Eigen::ConjugateGradient<Matrix, Eigen::Lower | Eigen::Upper, Preconditioner> Solver;
};

}

#endif
