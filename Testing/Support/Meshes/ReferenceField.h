// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceField_h
#define ReferenceField_h

#include "vtkType.h" // for ids

#include <array> // for linear functions

class vtkDataSet;
class vtkDataSetAttributes;
class vtkDoubleArray;

namespace reference
{

/// The linear function Constant + Gradient . x.
struct LinearFunction
{
  double Constant;
  std::array<double, 3> Gradient;

  template <typename Real>
  Real operator()(const Real* x) const
  {
    return this->Constant + this->Gradient[0] * x[0] + this->Gradient[1] * x[1] +
      this->Gradient[2] * x[2];
  }
};

/// Adds a point array of independent random numbers, uniform in [0, 1), and makes it the active
/// scalars.
vtkDoubleArray* AddRandomField(vtkDataSet* data, unsigned int seed, const char* name = "f");

/// Adds random integers in [0, values). If \a values is small, many edges and cells are constant.
vtkDoubleArray* AddIntegerField(
  vtkDataSet* data, int values, unsigned int seed, const char* name = "f");

vtkDoubleArray* AddLinearField(
  vtkDataSet* data, const LinearFunction& function, const char* name = "f");

/// Adds a ghost array of \a size values, which are 0 except \a value at the index \a at.
void SetGhost(vtkDataSetAttributes* attributes, vtkIdType size, vtkIdType at, unsigned char value);

}

#endif
