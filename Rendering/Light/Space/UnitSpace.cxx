// SPDX-License-Identifier: BSD-3-Clause
#include "Space/UnitSpace.h"

#include "Space/UnitVector.h"

#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"

namespace interlume
{

namespace
{

using namespace UnitVector;

// Columns of the linear part.
glm::dvec3 GetColumn(const Matrix& matrix, std::size_t column)
{
  return { matrix[column], matrix[4 + column], matrix[8 + column] };
}

Matrix MakeAffine(const double linear[9], const glm::dvec3& translation)
{
  Matrix matrix{};
  for (std::size_t row = 0; row < 3; ++row)
  {
    std::copy(linear + 3 * row, linear + 3 * row + 3, matrix.begin() + 4 * row);
    matrix[4 * row + 3] = translation[row];
  }
  matrix[15] = 1.0;
  return matrix;
}

// \a from takes 0 at \a middle and goes with the linear part of \a to.
Matrix MakeCentered(const Matrix& to, const glm::dvec3& middle)
{
  Matrix matrix = to;
  const glm::dvec3 moved = TransformVector(to, middle);
  for (std::size_t row = 0; row < 3; ++row)
  {
    matrix[4 * row + 3] = -moved[row];
  }
  return matrix;
}

bool IsFinite(const Matrix& matrix)
{
  return std::all_of(
    matrix.begin(), matrix.end(), [](double value) { return std::isfinite(value); });
}

// The linear part of \a worldFromTexture over \a radius, and its inverse, each three rows. Returns
// whether there is an inverse.
bool Invert(const Matrix& worldFromTexture, double radius, double linear[9], double inverse[9])
{
  double lengths[3];
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const glm::dvec3 column = (1.0 / radius) * GetColumn(worldFromTexture, axis);
    lengths[axis] = Vectors::SafeLength(column);
    for (std::size_t row = 0; row < 3; ++row)
    {
      linear[3 * row + axis] = column[row];
    }
  }
  double directions[9];
  for (std::size_t i = 0; i < 9; ++i)
  {
    directions[i] = lengths[i % 3] > 0.0 ? linear[i] / lengths[i % 3] : 0.0;
  }
  constexpr double flattest = 1e-12;
  if (!(std::abs(vtkMatrix3x3::Determinant(directions)) > flattest))
  {
    return false;
  }
  vtkMatrix3x3::Invert(directions, inverse);
  for (std::size_t i = 0; i < 9; ++i)
  {
    inverse[i] /= lengths[i / 3];
  }
  return true;
}

}

bool UnitSpace::SetTexels(vtkImageData* image, bool isOfCells, glm::dvec3& middleIndex)
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
    const double indexOfTexture0 = extent[2 * axis] - (isOfCells && !isFlat ? 0.0 : 0.5);
    this->Box[axis] = isOfCells || isFlat ? std::array<double, 2>{ { 0.0, 1.0 } }
                                          : std::array<double, 2>{ { half, 1.0 - half } };
    middleIndex[axis] = indexOfTexture0 + 0.5 * size;
  }
  return true;
}

void UnitSpace::SetSphere(const Matrix& worldFromTexture, const glm::dvec3& center)
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

std::string UnitSpace::Set(vtkImageData* image, bool isOfCells, vtkMatrix4x4* worldFromVolume)
{
  glm::dvec3 index;
  if (!this->SetTexels(image, isOfCells, index))
  {
    return "the image has no samples";
  }
  Matrix volumeFromIndex;
  std::copy_n(image->GetIndexToPhysicalMatrix()->GetData(), 16, volumeFromIndex.begin());
  Matrix worldFromIndex;
  vtkMatrix4x4::Multiply4x4(
    worldFromVolume->GetData(), volumeFromIndex.data(), worldFromIndex.data());
  if (!IsFinite(worldFromIndex) || !IsFinite(volumeFromIndex))
  {
    return "the matrix of the volume or its image is not finite";
  }
  const double* last = worldFromVolume->GetData() + 12;
  if (last[0] != 0.0 || last[1] != 0.0 || last[2] != 0.0 || last[3] != 1.0)
  {
    return "the matrix of the volume is not affine";
  }

  Matrix worldFromTexture = worldFromIndex;
  Matrix volumeFromTexture = volumeFromIndex;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    for (std::size_t row = 0; row < 3; ++row)
    {
      worldFromTexture[4 * row + axis] *= this->Size[axis];
      volumeFromTexture[4 * row + axis] *= this->Size[axis];
    }
  }
  // Places are computed from the middle on, so that nothing cancels far from the origin.
  this->SetSphere(worldFromTexture, TransformPoint(worldFromIndex, index));
  if (!std::isfinite(this->Radius) || !(this->Radius > 0.0) || !std::isfinite(1.0 / this->Radius))
  {
    return "the volume's size is 0 or not finite";
  }

  double linear[9];
  double inverse[9];
  if (!Invert(worldFromTexture, this->Radius, linear, inverse))
  {
    return "the matrix of the volume or its image is singular";
  }
  const glm::dvec3 none{ 0.0, 0.0, 0.0 };
  const glm::dvec3 middle{ 0.5, 0.5, 0.5 };
  this->UnitFromTexture = MakeCentered(MakeAffine(linear, none), middle);
  this->TextureFromUnit = MakeAffine(inverse, middle);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const glm::dvec3 column =
      TransformVector(volumeFromTexture, GetColumn(this->TextureFromUnit, axis));
    for (std::size_t row = 0; row < 3; ++row)
    {
      linear[3 * row + axis] = column[row];
    }
  }
  this->VolumeFromUnit = MakeAffine(linear, TransformPoint(volumeFromIndex, index));
  const bool isFinite = IsFinite(this->TextureFromUnit) && IsFinite(this->UnitFromTexture) &&
    IsFinite(this->VolumeFromUnit);
  return isFinite ? "" : "the matrix of the volume or its image is not finite";
}

glm::dvec3 UnitSpace::ToUnit(const double world[3]) const
{
  return (glm::make_vec3(world) - this->Center) / this->Radius;
}

}
