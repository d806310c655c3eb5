// SPDX-License-Identifier: BSD-3-Clause
#include "Interpolation/LinearFit.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace interlume
{

using Place = Eigen::Map<const Eigen::Vector3d>;

LinearFit::LinearFit(const Tetrahedra& mesh, const std::vector<double>& values)
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
      this->Center += Place(&mesh.Points[3 * p]);
    }
  }
  this->Constant /= std::max(number, 1.0);
  this->Center /= std::max(number, 1.0);
  // Each axis in units of its own extent, so that a thin mesh is as well fitted as a cube.
  Eigen::Array3d extent = Eigen::Array3d::Zero();
  for (std::size_t p = 0; p < values.size(); ++p)
  {
    extent = extent.max((Place(&mesh.Points[3 * p]) - this->Center).array().abs());
  }
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (std::size_t p = 0; p < values.size(); ++p)
  {
    if (isKnown(p))
    {
      const Eigen::Vector3d x = (Place(&mesh.Points[3 * p]) - this->Center).array() / extent;
      normal += x * x.transpose();
      right += (values[p] - this->Constant) * x;
    }
  }
  // Of sizes that the compiler does not know, since GCC 16 sees reads beyond Eigen 5's fixed ones.
  const Eigen::VectorXd slopes =
    Eigen::MatrixXd(normal).completeOrthogonalDecomposition().solve(Eigen::VectorXd(right));
  this->Gradient = slopes.array() / extent;
}

double LinearFit::operator()(const double* point) const
{
  return this->Constant + this->Gradient.dot(Place(point) - this->Center);
}

}
