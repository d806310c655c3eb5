// SPDX-License-Identifier: BSD-3-Clause
// Time spacings of 1e9 or 1e-9 and times near 1e9 yield the same slice as a spacing of 1.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Meshes/ReferenceGrid.h"
#include "Support/Meshes/ReferenceVolume.h"
#include "Support/TimeVarying/ReferenceSimplexGrid.h"

#include "vtkDoubleArray.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>

namespace
{

using namespace reference;

struct Scale
{
  const char* Name;
  double Step;
  double Offset;
  /// Largest allowed error of a position, due to rounded times.
  double Tolerance;
};

/// Returns options for a grid whose times are multiples of 1/8, so that scaling by a power of 2 is
/// exact.
KuhnOptions MakeOptions()
{
  KuhnOptions options;
  options.MovedInSpace = 0.15;
  options.MovedInTime = 0.19;
  options.HasEqualTimes = true;
  return options;
}

void CheckScale(const Scale& scale, double t, Check& check)
{
  check.SetContext(std::string(scale.Name) + ", t = " + std::to_string(t));
  auto grid = MakeKuhnGrid(MakeOptions());
  auto expected = SliceAt(grid, t);
  auto* times = vtkDoubleArray::SafeDownCast(grid->GetPointData()->GetArray("Time"));
  std::transform(times->Begin(), times->End(), times->Begin(),
    [&scale](double time) { return scale.Step * time + scale.Offset; });
  times->Modified();
  grid->Modified();
  auto found = SliceAt(grid, scale.Step * t + scale.Offset);
  check.Near(
    static_cast<double>(MeasureTetrahedra(found).Sum), 1.0, scale.Tolerance + 1e-13, "volume");
  if (!check.Equal(found->GetNumberOfPoints(), expected->GetNumberOfPoints(), "points") ||
    !check.Equal(found->GetNumberOfCells(), expected->GetNumberOfCells(), "cells"))
  {
    return;
  }
  double most = 0;
  for (vtkIdType point = 0; point < found->GetNumberOfPoints(); ++point)
  {
    double a[3];
    double b[3];
    found->GetPoint(point, a);
    expected->GetPoint(point, b);
    for (int axis = 0; axis < 3; ++axis)
    {
      most = std::max(most, std::abs(a[axis] - b[axis]));
    }
  }
  check.Near(most, 0.0, scale.Tolerance, "error of the positions", 1.0);
}

}

int TestSimplexTimeSliceScales(int, char*[])
{
  Check check;
  const Scale scales[] = { { "2^30 apart", std::ldexp(1.0, 30), 0.0, 0.0 },
    { "2^-30 apart", std::ldexp(1.0, -30), 0.0, 0.0 },
    { "from 2^30", 1.0, std::ldexp(1.0, 30), 0.0 }, { "from -1e9", 1.0, -1e9, 0.0 },
    { "1e9 apart", 1e9, 0.0, 1e-14 }, { "1e-9 apart", 1e-9, 0.0, 1e-14 },
    { "1e-300 apart", 1e-300, 0.0, 1e-14 }, { "1e300 apart", 1e300, 0.0, 1e-14 },
    { "2^-20 apart from 1e9", std::ldexp(1.0, -20), 1e9, 0.0 } };
  for (const Scale& scale : scales)
  {
    for (const double t : { 0.0, 0.875, 1.0, 1.5, 3.0 })
    {
      CheckScale(scale, t, check);
    }
  }
  return check.Result();
}
