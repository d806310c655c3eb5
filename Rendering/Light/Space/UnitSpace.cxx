// SPDX-License-Identifier: BSD-3-Clause
#include "Space/UnitSpace.h"

#include "Space/UnitVector.h"

#include "vtkImageData.h"
#include "vtkMatrix4x4.h"

namespace interlume
{

namespace
{

using namespace UnitVector;

glm::dmat4 MakeAffine(const glm::dmat3& linear, const glm::dvec3& translation)
{
  glm::dmat4 matrix(linear);
  matrix[3] = glm::dvec4(translation, 1.0);
  return matrix;
}

bool IsFinite(const glm::dmat4& matrix)
{
  return std::all_of(glm::value_ptr(matrix), glm::value_ptr(matrix) + 16,
    [](double value) { return std::isfinite(value); });
}

// Inverts a matrix whose columns may differ widely in length. Returns false if it is singular.
bool Invert(const glm::dmat3& linear, glm::dmat3& inverse)
{
  glm::dvec3 lengths;
  glm::dmat3 directions;
  for (int axis = 0; axis < 3; ++axis)
  {
    lengths[axis] = Vectors::SafeLength(linear[axis]);
    directions[axis] = lengths[axis] > 0.0 ? linear[axis] / lengths[axis] : glm::dvec3(0.0);
  }
  constexpr double smallestDeterminant = 1e-12;
  if (!(std::abs(glm::determinant(directions)) > smallestDeterminant))
  {
    return false;
  }
  inverse = glm::inverse(directions);
  for (int axis = 0; axis < 3; ++axis)
  {
    inverse[axis] /= lengths;
  }
  return true;
}

}

bool UnitSpace::SetTexelGrid(
  vtkImageData* image, bool isOfCells, glm::dvec3& firstIndex, glm::dvec3& centerIndex)
{
  int extent[6];
  image->GetExtent(extent);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const int points = extent[2 * axis + 1] - extent[2 * axis] + 1;
    if (points < 1)
    {
      return false;
    }
    const bool isFlat = points == 1;
    const int size = isOfCells && !isFlat ? points - 1 : points;
    const double half = 0.5 / size;
    this->Size[axis] = size;
    firstIndex[axis] = extent[2 * axis] - (isOfCells && !isFlat ? 0.0 : 0.5);
    this->Box[axis] = isOfCells || isFlat ? std::array<double, 2>{ { 0.0, 1.0 } }
                                          : std::array<double, 2>{ { half, 1.0 - half } };
    centerIndex[axis] = firstIndex[axis] + 0.5 * size;
  }
  return true;
}

void UnitSpace::SetSphere(const glm::dmat4& worldFromTexture, const glm::dvec3& center)
{
  this->Center = center;
  this->Radius = 0.0;
  for (unsigned corner = 0; corner < 8; ++corner)
  {
    glm::dvec3 offset;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      offset[axis] = this->Box[axis][corner >> axis & 1u] - 0.5;
    }
    this->Radius =
      std::max(this->Radius, Vectors::SafeLength(TransformVector(worldFromTexture, offset)));
  }
}

Error UnitSpace::Set(vtkImageData* image, bool isOfCells, vtkMatrix4x4* worldFromVolume)
{
  glm::dvec3 first;
  glm::dvec3 index;
  if (!this->SetTexelGrid(image, isOfCells, first, index))
  {
    return "The image has no samples.";
  }
  const glm::dmat4 volumeFromIndex = FromRows(image->GetIndexToPhysicalMatrix()->GetData());
  const glm::dmat4 worldFromIndex = FromRows(worldFromVolume->GetData()) * volumeFromIndex;
  if (!IsFinite(worldFromIndex) || !IsFinite(volumeFromIndex))
  {
    return "The matrix from image to world coordinates is not finite. Check the image's origin, "
           "spacing and direction matrix and the volume's matrix.";
  }
  const double* last = worldFromVolume->GetData() + 12;
  if (last[0] != 0.0 || last[1] != 0.0 || last[2] != 0.0 || last[3] != 1.0)
  {
    return "The matrix of the volume is not affine. Perspective matrices are not supported.";
  }

  glm::dmat4 worldFromTexture = worldFromIndex;
  this->VolumeFromTexture = volumeFromIndex;
  for (int axis = 0; axis < 3; ++axis)
  {
    worldFromTexture[axis] *= this->Size[axis];
    this->VolumeFromTexture[axis] *= this->Size[axis];
  }
  this->VolumeFromTexture[3] = glm::dvec4(TransformPoint(volumeFromIndex, first), 1.0);
  // Compute relative to the volume's center, to avoid cancellation far from the origin.
  this->SetSphere(worldFromTexture, TransformPoint(worldFromIndex, index));
  if (!std::isfinite(this->Radius) || !(this->Radius > 0.0) || !std::isfinite(1.0 / this->Radius))
  {
    return "The size of the volume is 0 or not finite. Check the image's spacing and the "
           "volume's matrix.";
  }

  const glm::dmat3 linear = (1.0 / this->Radius) * glm::dmat3(worldFromTexture);
  glm::dmat3 inverse;
  if (!Invert(linear, inverse))
  {
    return "The matrix from image to world coordinates is singular. Check the image's spacing and "
           "direction matrix and the volume's matrix.";
  }
  const glm::dvec3 textureCenter{ 0.5, 0.5, 0.5 };
  this->UnitFromTexture = MakeAffine(linear, -(linear * textureCenter));
  this->TextureFromUnit = MakeAffine(inverse, textureCenter);
  const bool isFinite = IsFinite(this->TextureFromUnit) && IsFinite(this->UnitFromTexture) &&
    IsFinite(this->VolumeFromTexture);
  return isFinite ? ""
                  : "The matrix from image to world coordinates is not finite. Check the image's "
                    "origin, spacing and direction matrix and the volume's matrix.";
}

void UnitSpace::MoveTo(const glm::dvec3& center, double radius)
{
  const double scale = radius / this->Radius;
  const glm::dvec3 moved = (center - this->Center) / this->Radius;
  glm::dmat4 oldFromNew(glm::dmat3{ scale });
  oldFromNew[3] = glm::dvec4(moved, 1.0);
  glm::dmat4 newFromOld(glm::dmat3{ 1.0 / scale });
  newFromOld[3] = glm::dvec4(-moved / scale, 1.0);
  this->TextureFromUnit = this->TextureFromUnit * oldFromNew;
  this->UnitFromTexture = newFromOld * this->UnitFromTexture;
  this->Center = center;
  this->Radius = radius;
}

std::array<double, 3> UnitSpace::GetMargins(double margin) const
{
  std::array<double, 3> margins;
  for (int axis = 0; axis < 3; ++axis)
  {
    margins[static_cast<std::size_t>(axis)] =
      margin * Vectors::SafeLength(UnitVector::GetRow(this->TextureFromUnit, axis));
  }
  return margins;
}

glm::dvec3 UnitSpace::GetTexels(const glm::dvec3& vector) const
{
  return UnitVector::TransformVector(this->TextureFromUnit, vector) *
    glm::dvec3(this->Size[0], this->Size[1], this->Size[2]);
}

glm::dvec3 UnitSpace::ToUnit(const double world[3]) const
{
  return (glm::make_vec3(world) - this->Center) / this->Radius;
}

glm::dmat4 UnitSpace::GetWorldFromUnit() const
{
  return MakeAffine(glm::dmat3(this->Radius), this->Center);
}

glm::dmat4 UnitSpace::GetUnitFromWorld() const
{
  return MakeAffine(glm::dmat3(1.0 / this->Radius), -this->Center / this->Radius);
}

}
