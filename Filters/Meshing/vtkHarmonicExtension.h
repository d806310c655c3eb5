#ifndef vtkHarmonicExtension_h
#define vtkHarmonicExtension_h

#include "vtkType.h"

#include <functional>
#include <vector>

struct vtkTetrahedra;

/**
 * @class   vtkHarmonicExtension
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
 * Solved by conjugate gradients with a diagonal preconditioner, in one fixed order of operations.
 */
class vtkHarmonicExtension
{
public:
  /// The unknown values are those of the points of \a mesh without a source. The mesh must outlive
  /// this object.
  explicit vtkHarmonicExtension(const vtkTetrahedra& mesh);

  /// Asked between iterations; true stops.
  std::function<bool()> IsCancelled;

  /// \a values: one for each point, known ones given. Fills in the others.
  void Extend(std::vector<double>& values) const;

private:
  void Multiply(const std::vector<double>& x, std::vector<double>& product) const;
  void Solve(const std::vector<double>& right, std::vector<double>& x) const;

  const vtkTetrahedra& Mesh;
  std::vector<vtkIdType> Unknowns; ///< points
  std::vector<vtkIdType> Rows;     ///< of a point, its row in the matrix; -1 for none
  // The matrix in compressed rows, with columns for all points.
  std::vector<vtkIdType> Starts;
  std::vector<vtkIdType> Columns;
  std::vector<double> Entries;
  std::vector<double> Diagonal;
};

#endif
