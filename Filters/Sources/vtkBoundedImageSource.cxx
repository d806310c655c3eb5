// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBoundedImageSource.h"

#include "Common/NamedValue.h"
#include "Sampling/SourceReport.h"

#include "vtkDataObject.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr int MinimumIndex = -32768;
constexpr int MaximumIndex = 32767;
}

vtkBoundedImageSource::vtkBoundedImageSource()
{
  this->SetNumberOfInputPorts(0);
  interlume::SourceReport().CopyTo(this->Report);
}

void vtkBoundedImageSource::SetWholeExtent(int x0, int x1, int y0, int y1, int z0, int z1)
{
  const int extent[6] = { x0, x1, y0, y1, z0, z1 };
  this->SetWholeExtent(extent);
}

void vtkBoundedImageSource::SetWholeExtent(const int extent[6])
{
  int clamped[6];
  for (int axis = 0; axis < 3; ++axis)
  {
    clamped[2 * axis] = std::max(MinimumIndex, std::min(extent[2 * axis], MaximumIndex));
    clamped[2 * axis + 1] =
      std::max(clamped[2 * axis], std::min(extent[2 * axis + 1], MaximumIndex));
  }
  if (!std::equal(clamped, clamped + 6, this->WholeExtent))
  {
    std::copy_n(clamped, 6, this->WholeExtent);
    this->Modified();
  }
}

void vtkBoundedImageSource::SetDimensions(int x, int y, int z)
{
  // Clamp before subtracting, to avoid an integer overflow.
  this->SetWholeExtent(0, std::max(x, 1) - 1, 0, std::max(y, 1) - 1, 0, std::max(z, 1) - 1);
}

void vtkBoundedImageSource::SetBounds(
  double x0, double x1, double y0, double y1, double z0, double z1)
{
  const double bounds[6] = { x0, x1, y0, y1, z0, z1 };
  this->SetBounds(bounds);
}

void vtkBoundedImageSource::SetBounds(const double bounds[6])
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const double length = bounds[2 * axis + 1] - bounds[2 * axis];
    if (!(length > 0.0) || !std::isfinite(length))
    {
      vtkErrorMacro("The bounds along axis " << axis << ", " << bounds[2 * axis] << " to "
                                             << bounds[2 * axis + 1]
                                             << ", must span a finite length greater than 0.");
      return;
    }
  }
  if (!std::equal(bounds, bounds + 6, this->Bounds))
  {
    std::copy_n(bounds, 6, this->Bounds);
    this->Modified();
  }
}

void vtkBoundedImageSource::GetOriginAndSpacing(double origin[3], double spacing[3]) const
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const int first = this->WholeExtent[2 * axis];
    const int last = this->WholeExtent[2 * axis + 1];
    const double length = this->Bounds[2 * axis + 1] - this->Bounds[2 * axis];
    spacing[axis] = length / std::max(last - first, 1);
    origin[axis] = this->Bounds[2 * axis] - first * spacing[axis];
  }
}

void vtkBoundedImageSource::SetGeometry(vtkImageData* image, const int extent[6]) const
{
  double origin[3];
  double spacing[3];
  this->GetOriginAndSpacing(origin, spacing);
  image->SetExtent(extent[0], extent[1], extent[2], extent[3], extent[4], extent[5]);
  image->SetOrigin(origin);
  image->SetSpacing(spacing);
}

int vtkBoundedImageSource::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkInformation* info = outputs->GetInformationObject(0);
  double origin[3];
  double spacing[3];
  this->GetOriginAndSpacing(origin, spacing);
  info->Set(vtkDataObject::ORIGIN(), origin, 3);
  info->Set(vtkDataObject::SPACING(), spacing, 3);
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), this->WholeExtent, 6);
  info->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
  return 1;
}

void vtkBoundedImageSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  interlume::NamedValue::Print(
    os, indent, { { "WholeExtent", this->WholeExtent }, { "Bounds", this->Bounds } });
  os << indent << "Report:\n";
  this->Report->PrintSelf(os, indent.GetNextIndent());
}
