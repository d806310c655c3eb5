// SPDX-License-Identifier: BSD-3-Clause
#include "Plan/ClipRegion.h"

#include "Common/Vectors.h"
#include "Space/UnitSpace.h"
#include "Space/UnitVector.h"

#include "vtkMath.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"

#include <algorithm>

namespace interlume
{

namespace
{
CroppingRegions::Matrix ToRows(const glm::dmat4& matrix)
{
  const glm::dmat4 rows = glm::transpose(matrix);
  CroppingRegions::Matrix result;
  std::copy_n(glm::value_ptr(rows), 16, result.begin());
  return result;
}
}

Error ClipRegion::Set(const Cuts& cuts, const UnitSpace& space)
{
  this->Box = space.Box;
  this->ClippingPlanes.clear();
  this->Regions = CroppingRegions();
  if (cuts.IsCropped)
  {
    this->Regions = CroppingRegions(cuts.CroppingPlanes, cuts.CroppingFlags,
      ToRows(space.VolumeFromTexture * space.TextureFromUnit));
    this->Regions.Cut(ToRows(space.VolumeFromTexture), this->Box, this->ClippingPlanes);
  }
  for (int i = 0; cuts.Planes && i < cuts.Planes->GetNumberOfItems(); ++i)
  {
    vtkPlane* plane = cuts.Planes->GetItem(i);
    double normal[3];
    double origin[3];
    plane->GetNormal(normal);
    plane->GetOrigin(origin);
    if (!(vtkMath::Normalize(normal) > 0.0))
    {
      return "Clipping plane " + std::to_string(i) +
        " has no normal. Set a normal that is finite and not 0.";
    }
    const glm::dvec3 position = space.ToUnit(origin);
    this->ClippingPlanes.push_back(
      { { normal[0], normal[1], normal[2], -glm::dot(glm::make_vec3(normal), position) } });
  }
  return {};
}

}
