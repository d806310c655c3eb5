// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Meshes/ReferenceBoundary.h"

#include "Support/Arrays/ReferenceVector.h"

#include "vtkCell.h"
#include "vtkDataSet.h"
#include "vtkGenericCell.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace reference
{

namespace
{

using Point = DomainBoundary::Point;

Point AreaVector(const std::vector<Point>& corners)
{
  Point sum = { 0, 0, 0 };
  for (size_t i = 2; i < corners.size(); ++i)
  {
    sum += 0.5 * Cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
  }
  return sum;
}

}

DomainBoundary::DomainBoundary(vtkDataSet* mesh)
  : Tolerance(1e-10 * mesh->GetLength())
{
  struct Candidate
  {
    int Uses = 0;
    std::vector<vtkIdType> Ring;
    Point Inside{};
  };
  std::map<std::vector<vtkIdType>, Candidate> candidates;
  vtkNew<vtkGenericCell> cell;
  for (vtkIdType c = 0; c < mesh->GetNumberOfCells(); ++c)
  {
    mesh->GetCell(c, cell);
    Point center = { 0, 0, 0 };
    for (int i = 0; i < cell->GetNumberOfPoints(); ++i)
    {
      Point x;
      cell->GetPoints()->GetPoint(i, x.data());
      center += (1.0 / cell->GetNumberOfPoints()) * x;
    }
    for (int f = 0; f < cell->GetNumberOfFaces(); ++f)
    {
      vtkCell* face = cell->GetFace(f);
      std::vector<vtkIdType> ring(face->GetPointIds()->begin(), face->GetPointIds()->end());
      if (face->GetCellType() == VTK_PIXEL)
      {
        std::swap(ring[2], ring[3]);
      }
      std::vector<vtkIdType> key = ring;
      std::sort(key.begin(), key.end());
      Candidate& candidate = candidates[key];
      ++candidate.Uses;
      candidate.Ring = ring;
      candidate.Inside = center;
    }
  }
  for (const auto& [key, candidate] : candidates)
  {
    if (candidate.Uses != 1)
    {
      continue;
    }
    Face face;
    for (vtkIdType id : candidate.Ring)
    {
      Point x;
      mesh->GetPoint(id, x.data());
      face.Corners.push_back(x);
    }
    Point area = AreaVector(face.Corners);
    if (Dot(area, candidate.Inside - face.Corners[0]) > 0)
    {
      std::reverse(face.Corners.begin(), face.Corners.end());
      area *= -1.0;
    }
    face.Area = GetNorm(area);
    face.Normal = (1.0 / face.Area) * area;
    this->Faces.push_back(face);
  }
}

bool DomainBoundary::Holds(const Face& face, const Point& point) const
{
  if (std::abs(Dot(face.Normal, point - face.Corners[0])) > this->Tolerance)
  {
    return false;
  }
  for (size_t i = 0; i < face.Corners.size(); ++i)
  {
    const Point& a = face.Corners[i];
    const Point edge = face.Corners[(i + 1) % face.Corners.size()] - a;
    if (Dot(Cross(edge, point - a), face.Normal) < -this->Tolerance * GetNorm(edge))
    {
      return false;
    }
  }
  return true;
}

int DomainBoundary::Find(const std::vector<Point>& points) const
{
  for (size_t f = 0; f < this->Faces.size(); ++f)
  {
    if (std::all_of(points.begin(), points.end(),
          [&](const Point& point) { return this->Holds(this->Faces[f], point); }))
    {
      return static_cast<int>(f);
    }
  }
  return -1;
}

double DomainBoundary::SignedArea(int face, const std::vector<Point>& triangle) const
{
  return Dot(AreaVector(triangle), this->Faces[face].Normal);
}

}
