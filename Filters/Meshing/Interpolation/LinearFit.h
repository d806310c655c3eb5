// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_LinearFit_h
#define interlume_LinearFit_h

#include "Mesh/Tetrahedra.h"

#include <Eigen/Core>

namespace interlume
{

/**
 * @class   LinearFit
 * @brief   the linear function nearest to given values, in the sense of least squares
 */
class LinearFit
{
public:
  /// Fits the values of the points of \a mesh that have a source, where finite. Across a plane that
  /// all of them lie in, the function is constant.
  LinearFit(const Tetrahedra& mesh, const std::vector<double>& values);

  double operator()(const double* point) const;

private:
  Eigen::Vector3d Center = Eigen::Vector3d::Zero();
  Eigen::Vector3d Gradient = Eigen::Vector3d::Zero();
  double Constant = 0.0;
};

}

#endif
