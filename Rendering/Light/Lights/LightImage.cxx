// SPDX-License-Identifier: BSD-3-Clause
#include "Lights/LightImage.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

namespace interlume
{

Error LightImage::GetError(const std::string& name) const
{
  int size[3];
  this->Image->GetDimensions(size);
  vtkDataArray* scalars = this->Image->GetPointData()->GetScalars();
  if (!scalars || scalars->GetNumberOfTuples() == 0)
  {
    return name + " has no samples";
  }
  if (size[2] != 1)
  {
    return name + " has " + std::to_string(size[2]) + " samples along z, not 1";
  }
  if (scalars->GetNumberOfTuples() != this->Image->GetNumberOfPoints())
  {
    return name + " has " + std::to_string(scalars->GetNumberOfTuples()) +
      " values, not one per point";
  }
  if (scalars->GetNumberOfComponents() > 4)
  {
    return name + " has " + std::to_string(scalars->GetNumberOfComponents()) +
      " components, not 1 to 4";
  }
  if (scalars->GetDataType() == VTK_BIT)
  {
    return name + " is of type bit, not an integer or floating-point type";
  }
  return {};
}

glm::dvec3 LightImage::GetSample(vtkIdType index) const
{
  vtkDataArray* scalars = this->Image->GetPointData()->GetScalars();
  const int type = scalars->GetDataType();
  const double largest = type == VTK_FLOAT || type == VTK_DOUBLE ? 1.0 : scalars->GetDataTypeMax();
  const int components = scalars->GetNumberOfComponents();
  // NaN becomes 0, because it is not above 0.
  const auto value = [&](int component)
  {
    const double scaled = scalars->GetComponent(index, component) / largest;
    return scaled > 0.0 ? std::min(scaled, 1.0) : 0.0;
  };
  const double opacity = components % 2 == 0 ? value(components - 1) : 1.0;
  if (components < 3)
  {
    return glm::dvec3(opacity * value(0));
  }
  return opacity * glm::dvec3(value(0), value(1), value(2));
}

std::vector<float> LightImage::GetTexels() const
{
  const vtkIdType samples = this->Image->GetNumberOfPoints();
  std::vector<float> texels;
  texels.reserve(3 * static_cast<std::size_t>(samples));
  for (vtkIdType i = 0; i < samples; ++i)
  {
    const glm::dvec3 color = this->GetSample(i);
    texels.insert(texels.end(), glm::value_ptr(color), glm::value_ptr(color) + 3);
  }
  return texels;
}

glm::dvec3 LightImage::GetColor(double u, double v, bool isInterpolated) const
{
  int size[3];
  this->Image->GetDimensions(size);
  const double position[2] = { u * size[0] - 0.5, v * size[1] - 0.5 };
  double lower[2];
  double weight[2];
  for (int axis = 0; axis < 2; ++axis)
  {
    lower[axis] = isInterpolated ? std::floor(position[axis]) : std::floor(position[axis] + 0.5);
    weight[axis] = isInterpolated ? position[axis] - lower[axis] : 0.0;
  }
  glm::dvec3 color(0.0);
  for (int corner = 0; corner < 4; ++corner)
  {
    const int steps[2] = { corner % 2, corner / 2 };
    double product = 1.0;
    vtkIdType index[2];
    for (int axis = 0; axis < 2; ++axis)
    {
      product *= steps[axis] ? weight[axis] : 1.0 - weight[axis];
      index[axis] = static_cast<vtkIdType>(
        std::min(std::max(lower[axis] + steps[axis], 0.0), size[axis] - 1.0));
    }
    color += product * this->GetSample(index[1] * size[0] + index[0]);
  }
  return color;
}

}
