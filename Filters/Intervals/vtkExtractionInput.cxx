#include "vtkExtractionInput.h"

#include "vtkAbstractArray.h"
#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"

#include <cmath>
#include <sstream>

std::string vtkExtractionInput::CheckScalars(
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

std::string vtkExtractionInput::CheckInterval(const std::string& name, double lower, double upper)
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

std::string vtkExtractionInput::CheckIntervals(const std::vector<std::array<double, 2>>& intervals)
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

std::string vtkExtractionInput::DescribeArrayToProcess(vtkAlgorithm* owner)
{
  vtkInformation* info = owner->GetInputArrayInformation(0);
  if (info->Has(vtkDataObject::FIELD_NAME()))
  {
    return std::string("array \"") + info->Get(vtkDataObject::FIELD_NAME()) + "\"";
  }
  return "active point scalars";
}
