// SPDX-License-Identifier: BSD-3-Clause
#include "vtkEstimatedOpacity.h"

#include "OpacityEstimate.h"
#include "vtkScalarHistogramInformation.h"

#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPVArrayInformation.h"
#include "vtkSMPVRepresentationProxy.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMSourceProxy.h"
#include "vtkScalarsToColors.h"

#include <algorithm>
#include <vector>

namespace
{
/// Returns the component by which the display is colored, or -1 for the magnitude.
int FindComponent(vtkSMPVRepresentationProxy* display, vtkPVArrayInformation* array)
{
  if (array->GetNumberOfComponents() == 1)
  {
    return 0;
  }
  vtkSMProxy* colors = vtkSMPropertyHelper(display, "LookupTable").GetAsProxy();
  const bool isComponent =
    colors && vtkSMPropertyHelper(colors, "VectorMode").GetAsInt() == vtkScalarsToColors::COMPONENT;
  return isComponent ? vtkSMPropertyHelper(colors, "VectorComponent").GetAsInt() : -1;
}

/// Returns true if all values of the array are integers.
bool AreIntegers(vtkPVArrayInformation* array, int component)
{
  const int type = array->GetDataType();
  return component >= 0 && type != VTK_FLOAT && type != VTK_DOUBLE;
}

/// Extends the estimated function to the whole range, and returns it in the format of the property
/// Points.
std::vector<double> MakePoints(
  const std::vector<interlume::OpacityEstimate::Point>& estimate, const double range[2])
{
  std::vector<double> points;
  const auto add = [&](double value, double opacity) {
    points.insert(points.end(), { std::clamp(value, range[0], range[1]), opacity, 0.5, 0.0 });
  };
  if (estimate.front().Value > range[0])
  {
    add(range[0], estimate.front().Opacity);
  }
  for (const interlume::OpacityEstimate::Point& point : estimate)
  {
    add(point.Value, point.Opacity);
  }
  if (estimate.back().Value < range[1])
  {
    add(range[1], estimate.back().Opacity);
  }
  return points;
}
}

bool vtkEstimatedOpacity::IsDefault(vtkSMProxy* opacities)
{
  const std::vector<double> points = vtkSMPropertyHelper(opacities, "Points").GetDoubleArray();
  return points.size() == 8 && points[1] == 0.0 && points[5] == 1.0;
}

bool vtkEstimatedOpacity::Apply(vtkSMProxy* opacities, vtkSMPVRepresentationProxy* display)
{
  vtkPVArrayInformation* array = display->GetArrayInformationForColorArray();
  const vtkSMPropertyHelper input(display, "Input");
  auto* source = vtkSMSourceProxy::SafeDownCast(input.GetAsProxy());
  if (!array || !source)
  {
    return false;
  }
  const int component = FindComponent(display, array);
  if (component >= array->GetNumberOfComponents())
  {
    return false;
  }
  const double* range = array->GetComponentFiniteRange(component);
  if (!(range[0] < range[1]) || !IsDefault(opacities))
  {
    return range[0] <= range[1];
  }
  const vtkSMPropertyHelper name(display, "ColorArrayName");
  vtkNew<vtkScalarHistogramInformation> information;
  information->Initialize(static_cast<int>(input.GetOutputPort()), name.GetInputArrayAssociation(),
    name.GetInputArrayNameToProcess(), component,
    interlume::ValueHistogram::Make(range[0], range[1], AreIntegers(array, component)));
  source->GatherInformation(information);
  const std::vector<interlume::OpacityEstimate::Point> estimate =
    interlume::OpacityEstimate::Find(information->GetHistogram());
  if (!estimate.empty())
  {
    const std::vector<double> points = MakePoints(estimate, range);
    vtkSMPropertyHelper(opacities, "Points")
      .Set(points.data(), static_cast<unsigned int>(points.size()));
    opacities->UpdateVTKObjects();
  }
  return true;
}
