// SPDX-License-Identifier: BSD-3-Clause
#include "Plan/ClipRegion.h"

#include "Common/Vectors.h"
#include "Space/UnitSpace.h"

#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkMatrix3x3.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkVolumeMapper.h"

#include <algorithm>

namespace interlume
{

void ClipRegion::SetWhole(const UnitSpace& space)
{
  this->Box = space.Box;
  this->HasCropping = false;
}

void ClipRegion::Crop(vtkImageData* image, bool isOfCells, const UnitSpace& space,
  const std::array<double, 6>& croppingPlanes, int flags)
{
  this->SetWhole(space);
  this->CroppingFlags = flags;
  for (int axis = 0; axis < 3; ++axis)
  {
    this->CroppingLower[axis] = croppingPlanes[2 * axis];
    this->CroppingUpper[axis] = croppingPlanes[2 * axis + 1];
  }
  this->HasCropping = flags != VTK_CROP_SUBVOLUME || !image->GetDirectionMatrix()->IsIdentity();
  if (this->HasCropping)
  {
    return;
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    const double first = isOfCells ? 0.0 : 0.5;
    const auto toTexture = [&](double place)
    {
      const double index = (place - image->GetOrigin()[axis]) / image->GetSpacing()[axis] -
        image->GetExtent()[2 * axis];
      return (index + first) / space.Size[axis];
    };
    const double a = toTexture(this->CroppingLower[axis]);
    const double b = toTexture(this->CroppingUpper[axis]);
    std::array<double, 2>& range = this->Box[axis];
    range[0] = std::max(range[0], std::min(a, b));
    range[1] = std::min(range[1], std::max(a, b));
  }
}

std::string ClipRegion::Clip(vtkPlaneCollection* planes, const UnitSpace& space)
{
  this->ClippingPlanes.clear();
  for (int i = 0; planes && i < planes->GetNumberOfItems(); ++i)
  {
    vtkPlane* plane = planes->GetItem(i);
    double normal[3];
    double origin[3];
    plane->GetNormal(normal);
    plane->GetOrigin(origin);
    if (!(vtkMath::Normalize(normal) > 0.0))
    {
      return "clipping plane " + std::to_string(i) + " has no normal";
    }
    const glm::dvec3 place = space.ToUnit(origin);
    this->ClippingPlanes.push_back(
      { { normal[0], normal[1], normal[2], -glm::dot(glm::make_vec3(normal), place) } });
  }
  return {};
}

}
