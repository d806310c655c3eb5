#ifndef vtkLinearFit_h
#define vtkLinearFit_h

#include "vtkTetrahedra.h"

#include <array>

/**
 * @class   vtkLinearFit
 * @brief   the linear function nearest to given values, in the sense of least squares
 */
class vtkLinearFit
{
public:
  /// Fits the values of the points of \a mesh that have a source, where finite.
  vtkLinearFit(const vtkTetrahedra& mesh, const std::vector<double>& values);

  double operator()(const double* point) const;

private:
  std::array<double, 3> Center{ { 0.0, 0.0, 0.0 } };
  std::array<double, 3> Gradient{ { 0.0, 0.0, 0.0 } };
  double Constant = 0.0;
};

#endif
