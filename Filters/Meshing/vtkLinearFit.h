#ifndef vtkLinearFit_h
#define vtkLinearFit_h

#include "vtkTetrahedra.h"

#include <Eigen/Core>

/**
 * @class   vtkLinearFit
 * @brief   the linear function nearest to given values, in the sense of least squares
 */
class vtkLinearFit
{
public:
  /// Fits the values of the points of \a mesh that have a source, where finite. Across a plane that
  /// all of them lie in, the function is constant.
  vtkLinearFit(const vtkTetrahedra& mesh, const std::vector<double>& values);

  double operator()(const double* point) const;

private:
  Eigen::Vector3d Center = Eigen::Vector3d::Zero();
  Eigen::Vector3d Gradient = Eigen::Vector3d::Zero();
  double Constant = 0.0;
};

#endif
