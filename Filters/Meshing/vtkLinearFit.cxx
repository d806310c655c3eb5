#include "vtkLinearFit.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>

vtkLinearFit::vtkLinearFit(const vtkTetrahedra& mesh, const std::vector<double>& values)
{
  double number = 0.0;
  std::array<double, 3> extent{ { 0.0, 0.0, 0.0 } };
  for (std::size_t p = 0; p < values.size(); ++p)
  {
    if (mesh.Origins[p].NumberOfSources > 0 && std::isfinite(values[p]))
    {
      number += 1.0;
      this->Constant += values[p];
      for (int axis = 0; axis < 3; ++axis)
      {
        this->Center[axis] += mesh.Points[3 * p + axis];
      }
    }
  }
  this->Constant /= std::max(number, 1.0);
  for (double& coordinate : this->Center)
  {
    coordinate /= std::max(number, 1.0);
  }
  for (std::size_t p = 0; p < values.size(); ++p)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      extent[axis] =
        std::max(extent[axis], std::abs(mesh.Points[3 * p + axis] - this->Center[axis]));
    }
  }
  // Each axis in units of its own extent, so that a thin mesh is as well fitted as a cube.
  double normal[3][3] = { { 0.0 } };
  double right[3] = { 0.0, 0.0, 0.0 };
  for (std::size_t p = 0; p < values.size(); ++p)
  {
    if (mesh.Origins[p].NumberOfSources > 0 && std::isfinite(values[p]))
    {
      double x[3];
      for (int axis = 0; axis < 3; ++axis)
      {
        x[axis] = (mesh.Points[3 * p + axis] - this->Center[axis]) / extent[axis];
      }
      for (int i = 0; i < 3; ++i)
      {
        right[i] += x[i] * (values[p] - this->Constant);
        for (int j = 0; j < 3; ++j)
        {
          normal[i][j] += x[i] * x[j];
        }
      }
    }
  }
  double inverse[3][3];
  const double determinant = vtkMath::Determinant3x3(normal);
  if (determinant > 0.0)
  {
    vtkMath::Invert3x3(normal, inverse);
    for (int i = 0; i < 3; ++i)
    {
      for (int j = 0; j < 3; ++j)
      {
        this->Gradient[i] += inverse[i][j] * right[j] / extent[i];
      }
    }
  }
}

double vtkLinearFit::operator()(const double* point) const
{
  double value = this->Constant;
  for (int axis = 0; axis < 3; ++axis)
  {
    value += this->Gradient[axis] * (point[axis] - this->Center[axis]);
  }
  return value;
}
