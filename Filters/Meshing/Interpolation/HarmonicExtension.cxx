// SPDX-License-Identifier: BSD-3-Clause
#include "Interpolation/HarmonicExtension.h"

#include "Common/Vectors.h"
#include "Mesh/Tetrahedra.h"

#include <Eigen/QR>

#include <algorithm>
#include <array>
#include <cmath>

namespace interlume
{

namespace
{
/// Residual at which the iteration stops, relative to the initial residual.
constexpr double Tolerance = 1e-12;
constexpr int MaximumNumberOfIterations = 5000;

using Eigen::Index;

/// Returns the integral of grad(f_i) . grad(f_j) over a tetrahedron for each pair of its four
/// linear basis functions.
std::array<std::array<double, 4>, 4> ElementStiffness(const std::array<const double*, 4>& x)
{
  using namespace Vectors;
  // Outward normal of the triangle opposite each point. Its length is twice the triangle's area.
  std::array<glm::dvec3, 4> areas;
  for (int i = 0; i < 4; ++i)
  {
    const double* a = x[(i + 1) % 4];
    const double* b = x[(i + 2) % 4];
    const double* c = x[(i + 3) % 4];
    areas[i] = glm::cross(Difference(b, a), Difference(c, a));
    if (i % 2 != 0)
    {
      areas[i] = -areas[i];
    }
  }
  const double determinant = SixVolumes(x[0], x[1], x[2], x[3]);
  std::array<std::array<double, 4>, 4> matrix;
  for (int i = 0; i < 4; ++i)
  {
    for (int j = 0; j < 4; ++j)
    {
      matrix[i][j] = glm::dot(areas[i], areas[j]) / (6.0 * determinant);
    }
  }
  return matrix;
}

using Position = Eigen::Map<const Eigen::Vector3d>;

/// Least-squares linear fit of point values.
class LinearFit
{
public:
  /// Fits the finite values of the mesh points that have a source point. If these points lie in a
  /// plane, the fit with the smallest gradient is used.
  LinearFit(const interlume::Tetrahedra& mesh, const std::vector<double>& values);

  double operator()(const double* point) const;

private:
  Eigen::Vector3d Center = Eigen::Vector3d::Zero();
  Eigen::Vector3d Gradient = Eigen::Vector3d::Zero();
  double Constant = 0.0;
};

LinearFit::LinearFit(const interlume::Tetrahedra& mesh, const std::vector<double>& values)
{
  const auto isKnown = [&](std::size_t p)
  { return mesh.Origins[p].NumberOfSources > 0 && std::isfinite(values[p]); };
  double number = 0.0;
  for (std::size_t p = 0; p < values.size(); ++p)
  {
    if (isKnown(p))
    {
      number += 1.0;
      this->Constant += values[p];
      this->Center += Position(&mesh.Points[3 * p]);
    }
  }
  this->Constant /= std::max(number, 1.0);
  this->Center /= std::max(number, 1.0);
  // Scale each axis by its extent so that a thin mesh is fitted as accurately as a cube.
  Eigen::Array3d extent = Eigen::Array3d::Zero();
  for (std::size_t p = 0; p < values.size(); ++p)
  {
    extent = extent.max((Position(&mesh.Points[3 * p]) - this->Center).array().abs());
  }
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (std::size_t p = 0; p < values.size(); ++p)
  {
    if (isKnown(p))
    {
      const Eigen::Vector3d x = (Position(&mesh.Points[3 * p]) - this->Center).array() / extent;
      normal += x * x.transpose();
      right += (values[p] - this->Constant) * x;
    }
  }
  // Use dynamic sizes: GCC 16 reports out-of-bounds reads in Eigen 5's fixed-size code.
  const Eigen::VectorXd slopes =
    Eigen::MatrixXd(normal).completeOrthogonalDecomposition().solve(Eigen::VectorXd(right));
  this->Gradient = slopes.array() / extent;
}

double LinearFit::operator()(const double* point) const
{
  return this->Constant + this->Gradient.dot(Position(point) - this->Center);
}

/// Exception that stops the solver, which has no other means of cancellation.
struct Canceled
{
};
}

HarmonicExtension::HarmonicExtension(const interlume::Tetrahedra& mesh)
  : Mesh(mesh)
  , Rows(mesh.Origins.size(), -1)
{
  for (std::size_t p = 0; p < mesh.Origins.size(); ++p)
  {
    if (mesh.Origins[p].NumberOfSources == 0)
    {
      this->Rows[p] = static_cast<vtkIdType>(this->Unknowns.size());
      this->Unknowns.push_back(static_cast<vtkIdType>(p));
    }
  }
  using Entry = Eigen::Triplet<double, Index>;
  std::vector<Entry> unknown;
  std::vector<Entry> known;
  for (std::size_t t = 0; t < mesh.Tetrahedra.size(); t += 4)
  {
    const vtkIdType* points = &mesh.Tetrahedra[t];
    if (std::all_of(points, points + 4, [this](vtkIdType p) { return this->Rows[p] < 0; }))
    {
      continue;
    }
    const auto matrix = ElementStiffness({ { &mesh.Points[3 * points[0]],
      &mesh.Points[3 * points[1]], &mesh.Points[3 * points[2]], &mesh.Points[3 * points[3]] } });
    for (int i = 0; i < 4; ++i)
    {
      const Index row = this->Rows[points[i]];
      for (int j = 0; row >= 0 && j < 4; ++j)
      {
        const Index column = this->Rows[points[j]];
        column >= 0 ? unknown.emplace_back(row, column, matrix[i][j])
                    : known.emplace_back(row, points[j], matrix[i][j]);
      }
    }
  }
  const auto rows = static_cast<Index>(this->Unknowns.size());
  this->Stiffness.resize(rows, rows);
  this->Stiffness.setFromTriplets(unknown.begin(), unknown.end());
  this->Coupling.resize(rows, static_cast<Index>(mesh.Origins.size()));
  this->Coupling.setFromTriplets(known.begin(), known.end());
  this->Solver.setTolerance(Tolerance);
  this->Solver.setMaxIterations(MaximumNumberOfIterations);
  this->Solver.compute(this->Stiffness);
  this->Solver.preconditioner().BeforeStep = [this]()
  {
    if (this->IsCanceled && this->IsCanceled())
    {
      throw Canceled();
    }
  };
}

void HarmonicExtension::Extend(std::vector<double>& values) const
{
  if (this->Unknowns.empty())
  {
    return;
  }
  const LinearFit fit(this->Mesh, values);
  double lowest = VTK_DOUBLE_MAX;
  double highest = -VTK_DOUBLE_MAX;
  double largest = 0.0;
  Eigen::VectorXd rest = Eigen::VectorXd::Zero(static_cast<Index>(values.size()));
  for (std::size_t p = 0; p < values.size(); ++p)
  {
    if (this->Rows[p] < 0 && std::isfinite(values[p]))
    {
      lowest = std::min(lowest, values[p]);
      highest = std::max(highest, values[p]);
      double& own = rest[static_cast<Index>(p)];
      own = values[p] - fit(&this->Mesh.Points[3 * p]);
      largest = std::max(largest, std::abs(own));
    }
  }
  // Scale by the largest deviation so that products do not overflow.
  if (largest > 0.0)
  {
    rest /= largest;
  }
  Eigen::VectorXd x = Eigen::VectorXd::Zero(this->Stiffness.rows());
  try
  {
    // Degenerate tetrahedra make coefficients infinite. Then use the linear fit alone.
    if (this->Stiffness.coeffs().allFinite())
    {
      x = this->Solver.solve(-(this->Coupling * rest));
    }
  }
  catch (const Canceled&)
  {
    return;
  }
  for (std::size_t row = 0; row < this->Unknowns.size(); ++row)
  {
    const vtkIdType p = this->Unknowns[row];
    const double value = largest * x[static_cast<Index>(row)] + fit(&this->Mesh.Points[3 * p]);
    values[p] = std::max(lowest, std::min(value, highest));
  }
}

}
