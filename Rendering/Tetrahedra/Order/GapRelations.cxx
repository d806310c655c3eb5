// SPDX-License-Identifier: BSD-3-Clause
#include "Order/GapRelations.h"

#include "Common/ParallelFor.h"
#include "Common/Vectors.h"
#include "Order/EdgeOnRule.h"
#include "Order/FrontNeighbors.h"
#include "Order/FaceRaster.h"
#include "Order/ViewRayEvents.h"
#include "View/FrameProjection.h"

#include <algorithm>

namespace interlume
{

namespace
{
constexpr vtkIdType GapGrain = 2048;
// Number of rows per band. The event lists of a band should fit in the CPU cache.
constexpr int BandHeight = 16;

using Relations = std::vector<ViewRayEvents::Relation>;

// Rasterizes the open faces of a mesh.
class OpenFaceRaster
{
public:
  OpenFaceRaster(const TetrahedraMesh& mesh, const FrontNeighbors& sides, const ViewRays& rays,
    const FrameProjection& projection)
    : Mesh(mesh)
    , Sides(sides)
    , Projection(projection)
    , Rule(rays.Viewpoint, sides.GetRadius())
    , Tolerance(1e-9 * sides.GetRadius() + 1e-12 * Vectors::InfinityNorm(rays.Viewpoint.Eye))
  {
  }

  void FindRows();
  int GetNumberOfBands() const
  {
    return (this->Projection.GetHeight() + BandHeight - 1) / BandHeight;
  }
  // Finds the relations along the view rays of a band of rows, ascending and without duplicates.
  void RelateBand(int band, Relations& relations) const;

private:
  struct Hit
  {
    ViewRayEvents::Event Event;
    std::uint32_t Pixel;
  };

  bool IsEdgeOn(const std::array<glm::dvec3, 3>& points) const;
  FaceRaster MakeRaster(std::uint32_t face, bool& isEdgeOn) const;
  void FindHits(int firstRow, int lastRow, std::vector<Hit>& hits) const;

  const TetrahedraMesh& Mesh;
  const FrontNeighbors& Sides;
  const FrameProjection& Projection;
  EdgeOnRule Rule;
  double Tolerance;
  // Rows of each open face.
  std::vector<FrameProjection::Range> Rows;
};

bool OpenFaceRaster::IsEdgeOn(const std::array<glm::dvec3, 3>& points) const
{
  const glm::dvec3 u = points[1] - points[0];
  const glm::dvec3 v = points[2] - points[0];
  const double side = glm::dot(glm::cross(u, v), this->Rule.GetVectorToEye(points[0]));
  return std::abs(side) <= this->Rule.GetBound(Vectors::InfinityNorm(u) + Vectors::InfinityNorm(v));
}

FaceRaster OpenFaceRaster::MakeRaster(std::uint32_t face, bool& isEdgeOn) const
{
  const std::array<std::uint32_t, 3> ids = this->Sides.GetOutwardCorners(this->Mesh, face);
  std::array<glm::dvec3, 3> points;
  std::array<glm::dvec3, 3> corners;
  for (int i = 0; i < 3; ++i)
  {
    points[i] = glm::make_vec3(this->Mesh.GetPoint(ids[i]));
    corners[i] = this->Projection.Project(points[i]);
  }
  isEdgeOn = this->IsEdgeOn(points);
  return FaceRaster(this->Projection, corners, ids);
}

void OpenFaceRaster::FindRows()
{
  const std::vector<std::uint32_t>& faces = this->Sides.GetOpenFaces();
  this->Rows.resize(faces.size());
  ParallelFor(0, static_cast<vtkIdType>(faces.size()), GapGrain,
    [&](vtkIdType i)
    {
      bool isEdgeOn = false;
      const FaceRaster raster = this->MakeRaster(faces[i], isEdgeOn);
      const auto columns = raster.GetColumns();
      const bool isOutside = isEdgeOn || columns.First > columns.Last;
      this->Rows[i] = isOutside ? FrameProjection::Range{ 0, -1 } : raster.GetRows();
    });
}

void OpenFaceRaster::FindHits(int firstRow, int lastRow, std::vector<Hit>& hits) const
{
  const std::vector<std::uint32_t>& faces = this->Sides.GetOpenFaces();
  const int width = this->Projection.GetWidth();
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    const int first = std::max(firstRow, this->Rows[i].First);
    const int last = std::min(lastRow, this->Rows[i].Last);
    if (first > last)
    {
      continue;
    }
    bool isEdgeOn = false;
    const FaceRaster raster = this->MakeRaster(faces[i], isEdgeOn);
    for (int row = first; row <= last; ++row)
    {
      const std::uint32_t start = static_cast<std::uint32_t>(row - firstRow) * width;
      raster.VisitRow(row,
        [&](int column, double depth, bool isFront)
        {
          hits.push_back(
            { { depth, faces[i], isFront != this->Projection.IsMirrored() }, start + column });
        });
    }
  }
}

void OpenFaceRaster::RelateBand(int band, Relations& relations) const
{
  const int firstRow = band * BandHeight;
  const int lastRow = std::min(firstRow + BandHeight, this->Projection.GetHeight()) - 1;
  std::vector<Hit> hits;
  this->FindHits(firstRow, lastRow, hits);

  // Group the events by pixel (counting sort).
  const std::size_t pixels =
    static_cast<std::size_t>(lastRow - firstRow + 1) * this->Projection.GetWidth();
  std::vector<std::size_t> ends(pixels + 1, 0);
  for (const Hit& hit : hits)
  {
    ++ends[hit.Pixel + 1];
  }
  for (std::size_t pixel = 0; pixel < pixels; ++pixel)
  {
    ends[pixel + 1] += ends[pixel];
  }
  std::vector<ViewRayEvents::Event> events(hits.size());
  for (const Hit& hit : hits)
  {
    events[ends[hit.Pixel]++] = hit.Event;
  }
  std::size_t first = 0;
  for (std::size_t pixel = 0; pixel < pixels; ++pixel)
  {
    const std::size_t last = ends[pixel];
    if (last - first > 1)
    {
      ViewRayEvents::Relate(
        events.data() + first, events.data() + last, this->Tolerance, relations);
    }
    first = last;
  }
  std::sort(relations.begin(), relations.end());
  relations.erase(std::unique(relations.begin(), relations.end()), relations.end());
}
}

void GapRelations::Compute(
  const TetrahedraMesh& mesh, const FrontNeighbors& sides, const ViewRays& rays)
{
  this->Offsets.clear();
  this->InFront.clear();
  const FrameProjection projection(rays);
  if (!projection.IsValid() || sides.GetOpenFaces().empty())
  {
    return;
  }
  OpenFaceRaster raster(mesh, sides, rays, projection);
  raster.FindRows();
  std::vector<Relations> bands(raster.GetNumberOfBands());
  ParallelFor(0, static_cast<vtkIdType>(bands.size()), 1,
    [&](vtkIdType band) { raster.RelateBand(static_cast<int>(band), bands[band]); });

  Relations all;
  for (const Relations& band : bands)
  {
    all.insert(all.end(), band.begin(), band.end());
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  if (all.empty())
  {
    return;
  }
  this->Offsets.assign(static_cast<std::size_t>(mesh.GetNumberOfTetrahedra()) + 1, 0);
  this->InFront.reserve(all.size());
  for (const ViewRayEvents::Relation& relation : all)
  {
    ++this->Offsets[relation.Back + 1];
    this->InFront.push_back(relation.Front);
  }
  for (std::size_t t = 1; t < this->Offsets.size(); ++t)
  {
    this->Offsets[t] += this->Offsets[t - 1];
  }
}

std::size_t GapRelations::GetBytes() const
{
  return (this->Offsets.capacity() + this->InFront.capacity()) * sizeof(std::uint32_t);
}

}
