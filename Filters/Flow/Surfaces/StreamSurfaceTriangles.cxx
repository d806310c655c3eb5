// SPDX-License-Identifier: BSD-3-Clause
#include "Surfaces/StreamSurfaceTriangles.h"

#include "Common/ArrayCheck.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFlowStatus.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace interlume
{

namespace
{
// Reads the triangles of a dataset. Returns an error if a cell is not a triangle.
Error GetTriangles(vtkPointSet* input, std::vector<StreamSurfaceTriangles::Triangle>& triangles)
{
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < input->GetNumberOfCells(); ++cell)
  {
    input->GetCellPoints(cell, ids);
    if (ids->GetNumberOfIds() != 3)
    {
      return "Cell " + std::to_string(cell) + " has " + std::to_string(ids->GetNumberOfIds()) +
        " points. All cells must be triangles.";
    }
    triangles.push_back({ { ids->GetId(0), ids->GetId(1), ids->GetId(2) } });
  }
  return {};
}
}

vtkIdType StreamSurfaceTriangles::Points::Add(vtkIdType source, int contour, double length)
{
  this->Sources.push_back(source);
  this->Contours.push_back(contour);
  this->Lengths.push_back(length);
  return static_cast<vtkIdType>(this->Sources.size()) - 1;
}

int StreamSurfaceTriangles::GetContourId(int level, int curve) const
{
  return curve < 0 ? -1 : this->Levels[level].FirstContour + curve;
}

ContourLocator::Location StreamSurfaceTriangles::Locate(int level, vtkIdType point, int curve) const
{
  const double* uv = this->Arrays.GetParameters(point);
  const ContourLocator::Parameters location{ { uv[0], uv[1] } };
  const ContourLocator& locator = *this->Levels[level].Locator;
  return curve < 0 ? locator.Find(location) : locator.Find(location, curve);
}

void StreamSurfaceTriangles::Locate(vtkIdType point)
{
  if (this->LevelOfPoint[point] >= 0)
  {
    this->Locations[point] = this->Locate(this->LevelOfPoint[point], point, -1);
  }
}

void StreamSurfaceTriangles::FindLevels(vtkDataArray* values, vtkIdType numberOfPoints)
{
  std::map<std::pair<int, double>, int> known;
  this->LevelOfPoint.assign(numberOfPoints, -1);
  for (const Triangle& triangle : this->Triangles)
  {
    const vtkIdType t = static_cast<vtkIdType>(this->LevelOfTriangle.size());
    const std::pair<int, double> key(this->Arrays.GetId(triangle[0]), values->GetComponent(t, 0));
    const auto found = known.insert({ key, static_cast<int>(this->Levels.size()) });
    const int level = found.first->second;
    if (found.second)
    {
      this->Levels.emplace_back();
      this->Levels.back().Id = key.first;
      this->Levels.back().Value = key.second;
    }
    this->LevelOfTriangle.push_back(level);
    for (const vtkIdType p : triangle)
    {
      this->LevelOfPoint[p] = this->LevelOfPoint[p] < 0 ? level : this->LevelOfPoint[p];
    }
  }
}

std::array<StreamSurfaceTriangles::Corner, 3> StreamSurfaceTriangles::Unwrap(std::size_t t) const
{
  const Triangle& triangle = this->Triangles[t];
  const int level = this->LevelOfTriangle[t];
  std::array<Corner, 3> corners;
  for (int c = 0; c < 3; ++c)
  {
    corners[c].Location = this->LevelOfPoint[triangle[c]] == level
      ? this->Locations[triangle[c]]
      : this->Locate(level, triangle[c], -1);
  }
  // Use the contour that two corners share, or the first corner's contour if all three differ.
  const int curve = corners[1].Location.Curve == corners[2].Location.Curve
    ? corners[1].Location.Curve
    : corners[0].Location.Curve;
  if (curve < 0)
  {
    return corners;
  }
  double greatest = 0.0;
  for (int c = 0; c < 3; ++c)
  {
    if (corners[c].Location.Curve != curve)
    {
      corners[c].Location = this->Locate(level, triangle[c], curve);
    }
    greatest = std::max(greatest, corners[c].Location.Length);
  }
  const Contour& contour = this->Contours[this->GetContourId(level, curve)];
  for (Corner& corner : corners)
  {
    corner.IsShifted = contour.IsClosed && corner.Location.Length < greatest - 0.5 * contour.Length;
  }
  return corners;
}

StreamSurfaceTriangles::Points StreamSurfaceTriangles::MakeTriangles(vtkCellArray* cells) const
{
  Points made;
  for (std::size_t p = 0; p < this->Locations.size(); ++p)
  {
    made.Add(static_cast<vtkIdType>(p),
      this->GetContourId(this->LevelOfPoint[p], this->Locations[p].Curve),
      this->Locations[p].Length);
  }
  std::map<std::tuple<vtkIdType, int, bool>, vtkIdType> copies;
  cells->AllocateEstimate(static_cast<vtkIdType>(this->Triangles.size()), 3);
  for (std::size_t t = 0; t < this->Triangles.size(); ++t)
  {
    Triangle ids = this->Triangles[t];
    const std::array<Corner, 3> corners = this->Unwrap(t);
    for (int c = 0; c < 3; ++c)
    {
      const int contour = this->GetContourId(this->LevelOfTriangle[t], corners[c].Location.Curve);
      if (contour == made.Contours[ids[c]] && !corners[c].IsShifted)
      {
        continue;
      }
      const auto key = std::make_tuple(ids[c], contour, corners[c].IsShifted);
      auto copy = copies.find(key);
      if (copy == copies.end())
      {
        const double shift = corners[c].IsShifted ? this->Contours[contour].Length : 0.0;
        copy = copies.insert({ key, made.Add(ids[c], contour, corners[c].Location.Length + shift) })
                 .first;
      }
      ids[c] = copy->second;
    }
    cells->InsertNextCell(3, ids.data());
  }
  return made;
}

Error StreamSurfaceTriangles::Read(vtkPointSet* input)
{
  const auto checkInflow = [input]
  {
    return ArrayCheck::MakeSentence(
      ArrayCheck::FindCellError(input, "input", vtkFlowStatus::InflowArray(), 1))
      .Within("", " Pass output port 1 of vtkFlowVolume.");
  };
  Error error =
    this->Arrays.Find(input)
      .Then([&] { return ImplicitFlowArrays::CheckArray(input, vtkFlowStatus::TimeArray(), 1); })
      .Then(checkInflow)
      .Then([&] { return GetTriangles(input, this->Triangles); });
  if (!error)
  {
    this->FindLevels(
      input->GetCellData()->GetArray(vtkFlowStatus::InflowArray()), input->GetNumberOfPoints());
    this->Locations.resize(input->GetNumberOfPoints());
  }
  return error;
}

}
