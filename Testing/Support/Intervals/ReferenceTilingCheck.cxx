// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Intervals/ReferenceTilingCheck.h"

#include "Support/Intervals/ReferenceExtraction.h"
#include "Support/Meshes/ReferenceBoundary.h"
#include "Support/Meshes/ReferenceGrid.h"
#include "Support/Meshes/ReferenceVolume.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <iostream>

namespace reference
{

namespace
{

/// Returns the face in its more frequent orientation.
Triangle WithMajorOrientation(const FaceUse& use)
{
  Triangle triangle = use.Key;
  if (use.Net() < 0)
  {
    std::swap(triangle[1], triangle[2]);
  }
  return triangle;
}

constexpr double VolumeTolerance = 1e-12;

/// Returns the net uses of each simplex in \a uses minus those in \a subtracted. Both lists are
/// sorted by key.
template <size_t N>
std::vector<SimplexUse<N>> NetDifference(
  const std::vector<SimplexUse<N>>& uses, const std::vector<SimplexUse<N>>& subtracted)
{
  std::vector<SimplexUse<N>> result;
  auto t = subtracted.begin();
  for (const SimplexUse<N>& use : uses)
  {
    for (; t != subtracted.end() && t->Key < use.Key; ++t)
    {
      result.push_back(t->Reversed());
    }
    const bool same = t != subtracted.end() && t->Key == use.Key;
    const int net = use.Net() - (same ? (t++)->Net() : 0);
    result.push_back({ use.Key, std::max(net, 0), std::max(-net, 0) });
  }
  for (; t != subtracted.end(); ++t)
  {
    result.push_back(t->Reversed());
  }
  return result;
}

class TilingChecker
{
public:
  TilingChecker(vtkUnstructuredGrid* mesh, const std::vector<double>& bounds, bool generic,
    Check& check, TilingCounts& counts)
    : Mesh(mesh)
    , Bounds(bounds)
    , Generic(generic)
    , Test(check)
    , Counts(counts)
    , Boundary(mesh)
    , Covered(Boundary.GetNumberOfFaces(), 0.0)
  {
    std::vector<Interval> intervals;
    for (int i = 0; i < this->NumberOfIntervals(); ++i)
    {
      intervals.push_back({ bounds[i], bounds[i + 1] });
    }
    const Extraction extraction = ExtractIntervals(mesh, intervals);
    this->Volume = extraction.Volume;
    this->Surface = extraction.Surface;
  }

  void Run()
  {
    if (!this->Test.That(IsValid(this->Volume, VTK_TETRA), "port 0 consists of tetrahedra") ||
      !this->Test.That(IsValid(this->Surface, VTK_TRIANGLE), "port 1 consists of triangles") ||
      !this->Test.That(this->Volume->GetNumberOfCells() > 0, "the output has tetrahedra"))
    {
      return;
    }
    this->CheckVolume();
    for (int i = 0; i < this->NumberOfIntervals(); ++i)
    {
      this->CheckInterval(i);
    }
    for (int i = 0; i + 1 < this->NumberOfIntervals(); ++i)
    {
      this->CheckShared(i);
    }
    for (int face = 0; face < this->Boundary.GetNumberOfFaces(); ++face)
    {
      this->Test.Near(
        this->Covered[face], this->Boundary.GetArea(face), 1e-10, "area of a domain face");
    }
  }

private:
  int NumberOfIntervals() const { return static_cast<int>(this->Bounds.size()) - 1; }

  template <size_t N>
  std::vector<DomainBoundary::Point> PointsOf(const std::array<vtkIdType, N>& ids) const
  {
    std::vector<DomainBoundary::Point> points(N);
    for (size_t i = 0; i < N; ++i)
    {
      this->Volume->GetPoint(ids[i], points[i].data());
    }
    return points;
  }

  /// Compares the upper triangles of interval i with the lower triangles of interval i + 1. In
  /// boundary faces of the domain, interval i may have upper triangles that interval i + 1 does not
  /// have.
  void CheckShared(int i)
  {
    const auto upper = CountUses(ToOrientedSimplices(BoundaryOf(this->Surface, i, 1)));
    const auto lower =
      CountUses(ToOrientedSimplices(Reversed(BoundaryOf(this->Surface, i + 1, 0))));
    long long unmatched = 0;
    for (const FaceUse& remaining : NetDifference(upper, lower))
    {
      if (remaining.Net() == 0)
      {
        continue;
      }
      const auto points = this->PointsOf(WithMajorOrientation(remaining));
      const int face = this->Generic ? -1 : this->Boundary.Find(points);
      unmatched += face < 0;
      if (face >= 0)
      {
        this->Covered[face] += this->Boundary.SignedArea(face, points);
      }
    }
    this->Test.Equal(
      unmatched, 0, "unmatched triangles between interval " + std::to_string(i) + " and the next");
  }

  void CheckVolume()
  {
    const long double domain = MeshVolume(this->Mesh);
    const TetrahedraVolume volume = MeasureTetrahedra(this->Volume);
    this->Test.Near(static_cast<double>(volume.Sum), static_cast<double>(domain), VolumeTolerance,
      "sum of the signed volumes");
    this->Counts.Tetrahedra += volume.Count;
    this->Counts.Triangles += this->Surface->GetNumberOfCells();
    this->Counts.Inverted += volume.Inverted;
    this->Counts.NegativeVolume += static_cast<double>(volume.Negative / domain);
    this->Counts.VolumeError = std::max(
      this->Counts.VolumeError, static_cast<double>(std::abs(volume.Sum - domain) / domain));
    ++this->Counts.Extractions;
  }

  void CheckInterval(int i)
  {
    const std::string name = "interval " + std::to_string(i) + ": ";
    const std::vector<Tetrahedron> tetrahedra = TetrahedraOf(this->Volume, i);
    std::vector<Triangle> triangles;
    for (int side = 0; side < 2; ++side)
    {
      const std::vector<Triangle> part = BoundaryOf(this->Surface, i, side);
      this->CheckValues(part, this->Bounds[i + side], this->Bounds[i + side], name + "triangle");
      if (this->Generic)
      {
        this->Test.That(VerticesAreManifold(part),
          name + "the triangles of one side are manifold at their points");
      }
      triangles.insert(triangles.end(), part.begin(), part.end());
    }
    this->CheckValues(tetrahedra, this->Bounds[i], this->Bounds[i + 1], name + "tetrahedron");
    this->CheckFaces(tetrahedra, triangles, name);
    this->CheckEdges(triangles, name);
  }

  template <size_t N>
  void CheckValues(const std::vector<std::array<vtkIdType, N>>& simplices, double lower,
    double upper, const std::string& name)
  {
    vtkDataArray* values =
      this->Volume->GetPointData()->GetArray(this->Mesh->GetPointData()->GetScalars()->GetName());
    if (!this->Test.That(values != nullptr, "the output has the scalar array"))
    {
      return;
    }
    const double tolerance = 1e-14 * (this->Bounds.back() - this->Bounds.front());
    const bool inside = std::all_of(simplices.begin(), simplices.end(),
      [&](const auto& simplex)
      {
        return std::all_of(simplex.begin(), simplex.end(),
          [&](vtkIdType id)
          {
            const double value = values->GetComponent(id, 0);
            return value >= lower - tolerance && value <= upper + tolerance;
          });
      });
    this->Test.That(inside, name + "s have values in their interval");
  }

  void CheckFaces(const std::vector<Tetrahedron>& tetrahedra,
    const std::vector<Triangle>& triangles, const std::string& name)
  {
    const std::vector<FaceUse> faces = CountUses(FacesOf(tetrahedra));
    const std::vector<FaceUse> sides = CountUses(ToOrientedSimplices(triangles));
    long long overused = 0;
    for (const FaceUse& face : faces)
    {
      overused += face.Plus > 1 || face.Minus > 1 ? 1 : 0;
    }
    long long repeated = 0;
    for (const FaceUse& side : sides)
    {
      repeated += side.Total() > 1 ? 1 : 0;
    }
    this->Test.Equal(repeated, 0, name + "triangles used more than once");
    if (this->Generic)
    {
      this->Test.Equal(overused, 0, name + "faces used more than once with one orientation");
    }
    long long cracks = 0;
    for (const FaceUse& remaining : NetDifference(faces, sides))
    {
      if (remaining.Net() == 0)
      {
        continue;
      }
      const auto points = this->PointsOf(WithMajorOrientation(remaining));
      const int face = this->Boundary.Find(points);
      if (face < 0)
      {
        ++cracks;
      }
      else
      {
        this->Covered[face] += std::abs(remaining.Net()) * this->Boundary.SignedArea(face, points);
      }
    }
    this->Test.Equal(cracks, 0, name + "interior faces without a matching triangle");
  }

  void CheckEdges(const std::vector<Triangle>& triangles, const std::string& name)
  {
    long long open = 0;
    long long overused = 0;
    for (const EdgeUse& edge : CountUses(EdgesOf(triangles)))
    {
      overused += edge.Plus > 1 || edge.Minus > 1 ? 1 : 0;
      open += edge.Net() != 0 && this->Boundary.Find(this->PointsOf(edge.Key)) < 0 ? 1 : 0;
    }
    this->Test.Equal(open, 0, name + "open edges of triangles inside the domain");
    if (this->Generic)
    {
      this->Test.Equal(overused, 0, name + "edges used more than once with one orientation");
    }
  }

  vtkUnstructuredGrid* Mesh;
  const std::vector<double>& Bounds;
  bool Generic;
  Check& Test;
  TilingCounts& Counts;
  DomainBoundary Boundary;
  std::vector<double> Covered;
  vtkSmartPointer<vtkUnstructuredGrid> Volume;
  vtkSmartPointer<vtkUnstructuredGrid> Surface;
};

}

void CheckTiling(vtkUnstructuredGrid* mesh, const std::vector<double>& bounds, bool generic,
  Check& check, TilingCounts& counts)
{
  TilingChecker(mesh, bounds, generic, check, counts).Run();
}

void Print(const TilingCounts& counts, const std::string& name)
{
  std::cout << name << ": " << counts.Extractions << " extractions, " << counts.Tetrahedra
            << " tetrahedra, " << counts.Triangles << " triangles, " << counts.Inverted
            << " inverted, negative volume "
            << counts.NegativeVolume / std::max(counts.Extractions, 1)
            << " of the domain, volume error " << counts.VolumeError << '\n';
}

}
