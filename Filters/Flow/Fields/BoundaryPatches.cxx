// SPDX-License-Identifier: BSD-3-Clause
#include "Fields/BoundaryPatches.h"

#include "Cells/FaceExtent.h"
#include "Common/Vectors.h"

#include "vtkMath.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

#include <glm/common.hpp>

namespace interlume
{

namespace
{
/// Edge of a face, with its points sorted by id. IsReversed is true if the face traverses the edge
/// from the larger to the smaller id.
struct Side
{
  vtkIdType Points[2];
  int Face;
  bool IsReversed;

  bool operator<(const Side& other) const
  {
    return std::tie(this->Points[0], this->Points[1], this->Face) <
      std::tie(other.Points[0], other.Points[1], other.Face);
  }
  bool IsSame(const Side& other) const
  {
    return this->Points[0] == other.Points[0] && this->Points[1] == other.Points[1];
  }
};

int FindFirst(std::vector<int>& firsts, int face)
{
  while (firsts[face] != face)
  {
    firsts[face] = firsts[firsts[face]];
    face = firsts[face];
  }
  return face;
}

int GetCorners(const BoundaryPatches::FacePoints& getPoints, const ArrayRows& positions,
  vtkIdType face, vtkIdType* points, double (*corners)[3])
{
  const int number = getPoints(face, points);
  for (int i = 0; i < number; ++i)
  {
    positions.Get<3>(points[i], corners[i]);
  }
  return number;
}
}

void BoundaryPatches::Build(
  const std::vector<vtkIdType>& faces, const FacePoints& getPoints, const ArrayRows& positions)
{
  this->Faces = faces;
  const auto number = static_cast<int>(faces.size());
  std::vector<glm::dvec3> normals(faces.size());
  std::vector<Side> sides;
  vtkIdType points[4];
  double corners[4][3];
  for (int face = 0; face < number; ++face)
  {
    const int size = GetCorners(getPoints, positions, faces[face], points, corners);
    normals[face] = glm::make_vec3(FaceExtent::Of(corners, size, nullptr, 0).Normal);
    for (int i = 0; i < size; ++i)
    {
      const vtkIdType from = points[i];
      const vtkIdType to = points[(i + 1) % size];
      sides.push_back({ { std::min(from, to), std::max(from, to) }, face, to < from });
    }
  }
  vtkSMPTools::Sort(sides.begin(), sides.end());
  std::vector<int> firsts(faces.size());
  std::iota(firsts.begin(), firsts.end(), 0);
  const double minimumCosine = std::cos(vtkMath::RadiansFromDegrees(FeatureAngle));
  for (std::size_t i = 0; i + 1 < sides.size(); ++i)
  {
    const Side& one = sides[i];
    const Side& other = sides[i + 1];
    const bool isPair = one.IsSame(other) && !(i > 0 && sides[i - 1].IsSame(one)) &&
      !(i + 2 < sides.size() && sides[i + 2].IsSame(one));
    const double sign = one.IsReversed == other.IsReversed ? -1.0 : 1.0;
    if (isPair && sign * glm::dot(normals[one.Face], normals[other.Face]) >= minimumCosine)
    {
      const auto ends = std::minmax({ FindFirst(firsts, one.Face), FindFirst(firsts, other.Face) });
      firsts[ends.second] = ends.first;
    }
  }
  for (int face = 0; face < number; ++face)
  {
    firsts[face] = FindFirst(firsts, face);
  }
  this->Number(firsts);
  for (std::size_t face = 0; face < faces.size(); ++face)
  {
    const int size = GetCorners(getPoints, positions, faces[face], points, corners);
    this->Add(face, corners, size);
  }
}

void BoundaryPatches::Number(const std::vector<int>& firsts)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  this->Patches.clear();
  this->PatchIds.resize(firsts.size());
  for (std::size_t face = 0; face < firsts.size(); ++face)
  {
    if (static_cast<std::size_t>(firsts[face]) < face)
    {
      this->PatchIds[face] = this->PatchIds[firsts[face]];
      continue;
    }
    this->PatchIds[face] = this->GetNumberOfPatches();
    this->Patches.push_back({ glm::dvec3(infinity), glm::dvec3(-infinity), glm::dvec3(0.0) });
  }
}

void BoundaryPatches::Add(std::size_t index, const double (*corners)[3], int number)
{
  Patch& patch = this->Patches[this->PatchIds[index]];
  patch.Area += glm::abs(glm::cross(Vectors::Difference(corners[2], corners[0]),
    Vectors::Difference(corners[number - 1], corners[1])));
  for (int i = 0; i < number; ++i)
  {
    patch.Lower = glm::min(patch.Lower, glm::make_vec3(corners[i]));
    patch.Upper = glm::max(patch.Upper, glm::make_vec3(corners[i]));
  }
}

int BoundaryPatches::Find(vtkIdType face) const
{
  const auto found = std::lower_bound(this->Faces.begin(), this->Faces.end(), face);
  return found != this->Faces.end() && *found == face
    ? this->PatchIds[static_cast<std::size_t>(found - this->Faces.begin())]
    : -1;
}

void BoundaryPatches::GetParameters(int patch, const double x[3], double uv[2]) const
{
  const Patch& own = this->Patches[static_cast<std::size_t>(patch)];
  const double* area = glm::value_ptr(own.Area);
  const auto along = std::max_element(area, area + 3) - area;
  int direction = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    if (axis != along)
    {
      const double width = own.Upper[axis] - own.Lower[axis];
      const double part = width > 0.0 ? (x[axis] - own.Lower[axis]) / width : 0.0;
      uv[direction++] = std::min(std::max(part, 0.0), 1.0);
    }
  }
}

}
