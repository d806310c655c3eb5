// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Measures/SurfaceDistances.h"

#include "vtkTriangle.h"

#include <cmath>

void SurfaceDistances::AddTriangle(
  const double x[3][3], const std::function<double(const double point[3])>& distance)
{
  const double area = vtkTriangle::TriangleArea(x[0], x[1], x[2]);
  for (int i = 0; i < 3; ++i)
  {
    double point[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      point[axis] = (x[0][axis] + x[1][axis] + x[2][axis] + 3.0 * x[i][axis]) / 6.0;
    }
    const double away = distance(point);
    this->Integral += area / 3.0 * away;
    this->SquareIntegral += area / 3.0 * away * away;
  }
  this->Area += area;
}

double SurfaceDistances::GetRootMeanSquare() const
{
  return this->Area > 0.0 ? std::sqrt(this->SquareIntegral / this->Area) : 0.0;
}
