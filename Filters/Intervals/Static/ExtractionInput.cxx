// SPDX-License-Identifier: BSD-3-Clause
#include "Static/ExtractionInput.h"

#include "Static/ExtractionArrays.h"

#include "vtkAbstractArray.h"
#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkRectilinearGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace interlume
{

namespace
{
// Returns the least distance of two coordinates that follow each other and differ; 0 where there is
// none.
double FindLeastStep(vtkDataArray* coordinates)
{
  double least = 0.0;
  for (vtkIdType i = 1; i < coordinates->GetNumberOfTuples(); ++i)
  {
    const double step =
      std::abs(coordinates->GetComponent(i, 0) - coordinates->GetComponent(i - 1, 0));
    least = step > 0.0 && (least == 0.0 || step < least) ? step : least;
  }
  return least;
}
}

std::string ExtractionInput::CheckScalars(
  vtkDataSet* input, vtkAbstractArray* array, int association, const std::string& wanted)
{
  std::ostringstream what;
  if (!array)
  {
    what << "No scalar array to process: the input has no " << wanted << ".";
    return what.str();
  }
  const std::string name = array->GetName() ? array->GetName() : "(unnamed)";
  if (association != vtkDataObject::FIELD_ASSOCIATION_POINTS)
  {
    what << "Array \"" << name << "\" is not a point array; values are needed at the points.";
  }
  else if (!vtkDataArray::SafeDownCast(array))
  {
    what << "Array \"" << name << "\" is a " << array->GetClassName() << ", not numbers.";
  }
  else if (array->GetNumberOfComponents() != 1)
  {
    what << "Array \"" << name << "\" has " << array->GetNumberOfComponents()
         << " components; one is needed.";
  }
  else if (array->GetNumberOfTuples() != input->GetNumberOfPoints())
  {
    what << "Array \"" << name << "\" has " << array->GetNumberOfTuples() << " values for "
         << input->GetNumberOfPoints() << " points.";
  }
  return what.str();
}

std::string ExtractionInput::CheckInterval(const std::string& name, double lower, double upper)
{
  std::ostringstream what;
  if (!std::isfinite(lower) || !std::isfinite(upper))
  {
    what << name << " [" << lower << ", " << upper << "] is not finite.";
  }
  else if (lower > upper)
  {
    what << name << " has lower value " << lower << " above its upper value " << upper << ".";
  }
  return what.str();
}

std::string ExtractionInput::CheckIntervals(const std::vector<std::array<double, 2>>& intervals)
{
  for (std::size_t i = 0; i < intervals.size(); ++i)
  {
    std::string wrong =
      CheckInterval("Interval " + std::to_string(i), intervals[i][0], intervals[i][1]);
    if (!wrong.empty())
    {
      return wrong;
    }
  }
  return std::string();
}

std::string ExtractionInput::CheckPrecision(vtkDataSet* input, int precision)
{
  double sizes[3] = { 0.0, 0.0, 0.0 };
  if (vtkImageData* image = vtkImageData::SafeDownCast(input))
  {
    image->GetSpacing(sizes);
  }
  else if (vtkRectilinearGrid* grid = vtkRectilinearGrid::SafeDownCast(input))
  {
    vtkDataArray* axes[3] = { grid->GetXCoordinates(), grid->GetYCoordinates(),
      grid->GetZCoordinates() };
    std::transform(axes, axes + 3, sizes, FindLeastStep);
  }
  double size = 0.0;
  for (const double one : sizes)
  {
    size = one != 0.0 && (size == 0.0 || std::abs(one) < size) ? std::abs(one) : size;
  }
  if (size == 0.0 || ExtractionArrays::ChoosePointType(input, precision) != VTK_FLOAT)
  {
    return std::string();
  }
  double bounds[6];
  input->GetBounds(bounds);
  double farthest = 0.0;
  for (const double bound : bounds)
  {
    farthest = std::max(farthest, std::abs(bound));
  }
  constexpr double share = 0.01;
  const double rounding = 0.5 * farthest * std::numeric_limits<float>::epsilon();
  if (rounding <= share * size)
  {
    return std::string();
  }
  std::ostringstream what;
  what << "Points in single precision are off by up to " << rounding << ", and cells are " << size
       << " wide: they lie as far as " << farthest
       << " from the origin. Set OutputPointsPrecision to double, or move the origin.";
  return what.str();
}

std::string ExtractionInput::CheckPolyhedra(vtkIdType numberOfConcave)
{
  return numberOfConcave == 0 ? std::string()
                              : std::to_string(numberOfConcave) +
      " polyhedra are not seen whole from the mean of their points, since they or their faces are "
      "concave: the parts that they are cut into overlap, and volumes come out too large. Cut them "
      "into convex cells before.";
}

std::string ExtractionInput::DescribeArrayToProcess(vtkAlgorithm* owner)
{
  vtkInformation* info = owner->GetInputArrayInformation(0);
  if (info->Has(vtkDataObject::FIELD_NAME()))
  {
    return std::string("array \"") + info->Get(vtkDataObject::FIELD_NAME()) + "\"";
  }
  return "active point scalars";
}

}
