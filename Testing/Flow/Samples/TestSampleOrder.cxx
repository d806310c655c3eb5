// SPDX-License-Identifier: BSD-3-Clause
// The order in which samples are advected: each sample occurs once, the samples of a block are
// consecutive, and any positions are allowed.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceRandom.h"

#include "Samples/SampleOrder.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace
{

using namespace reference;
using interlume::SampleOrder;

/// Returns whether the order contains each sample from \a first to the last exactly once.
bool IsComplete(const SampleOrder& order, vtkIdType first, vtkIdType number)
{
  std::vector<vtkIdType> ids;
  for (vtkIdType i = 0; i < number - first; ++i)
  {
    ids.push_back(order[i]);
  }
  std::sort(ids.begin(), ids.end());
  for (vtkIdType i = first; i < number; ++i)
  {
    if (ids[static_cast<std::size_t>(i - first)] != i)
    {
      return false;
    }
  }
  return true;
}

void TestCodes(Check& check)
{
  const unsigned int index[3] = { 5, 3, 1022 };
  unsigned int code = 0;
  for (unsigned int bit = 0; bit < 30; ++bit)
  {
    code += (index[bit % 3] >> (bit / 3) & 1U) << bit;
  }
  check.Equal(SampleOrder::GetCode(index), code, "interleaved bits");
}

/// Runs of 8 consecutive samples of an image form blocks of 2 x 2 x 2 samples, runs of 64 form
/// blocks of 4 x 4 x 4, and runs of 512 form blocks of 8 x 8 x 8.
void TestBlocks(Check& check)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(16, 16, 16);
  image->SetOrigin(-3.0, 1e6, 0.0);
  image->SetSpacing(0.5, 2.0, 1e-3);
  const SampleOrder order(image, 0);
  check.That(IsComplete(order, 0, 4096), "each sample occurs once");
  for (const vtkIdType run : { 8, 64, 512 })
  {
    const int side = static_cast<int>(std::lround(std::cbrt(static_cast<double>(run))));
    for (vtkIdType begin = 0; begin < 4096; begin += run)
    {
      vtkIdType lower[3] = { 16, 16, 16 };
      vtkIdType upper[3] = { 0, 0, 0 };
      for (vtkIdType i = begin; i < begin + run; ++i)
      {
        const vtkIdType index[3] = { order[i] % 16, order[i] / 16 % 16, order[i] / 256 };
        for (int axis = 0; axis < 3; ++axis)
        {
          lower[axis] = std::min(lower[axis], index[axis]);
          upper[axis] = std::max(upper[axis], index[axis]);
        }
      }
      for (int axis = 0; axis < 3; ++axis)
      {
        check.Equal(static_cast<int>(upper[axis] - lower[axis]), side - 1, "width of a block");
      }
    }
  }
}

/// The order is complete for points in space, in a plane, on a line, or at one position, for an
/// empty set, and for non-finite points.
void TestShapes(Check& check)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Random random(7);
  for (const int dimensions : { 0, 1, 2, 3 })
  {
    for (const vtkIdType number : { 0, 1, 9, 1000 })
    {
      for (const bool isFinite : { true, false })
      {
        vtkNew<vtkPoints> points;
        points->SetDataTypeToDouble();
        for (vtkIdType i = 0; i < number; ++i)
        {
          double x[3] = { 1.0, 2.0, 3.0 };
          for (int axis = 0; axis < dimensions; ++axis)
          {
            x[axis] = random.Get(-1.0, 1.0);
          }
          x[i % 3] = isFinite || i % 7 > 2
            ? x[i % 3]
            : (i % 7 == 0 ? infinity : (i % 7 == 1 ? -infinity : std::nan("")));
          points->InsertNextPoint(x);
        }
        vtkNew<vtkPolyData> samples;
        samples->SetPoints(points);
        for (const vtkIdType first : { vtkIdType(0), number / 2 })
        {
          check.That(IsComplete(SampleOrder(samples, first), first, number),
            std::to_string(number) + " samples of " + std::to_string(dimensions) + " dimensions");
        }
      }
    }
  }
}

}

int TestSampleOrder(int, char*[])
{
  Check check;
  TestCodes(check);
  TestBlocks(check);
  TestShapes(check);
  return check.Result();
}
