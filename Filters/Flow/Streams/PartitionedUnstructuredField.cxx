// SPDX-License-Identifier: BSD-3-Clause
#include "Streams/PartitionedUnstructuredField.h"

#include "Streams/MessageBytes.h"
#include "Streams/PartitionBoundaryFaces.h"
#include "Streams/PartitionedPatches.h"
#include "Streams/SharedPoints.h"

#include "vtkCellType.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <utility>

namespace interlume
{

namespace
{
/// Returns a VTK cell type with the given shape.
int GetType(int shape)
{
  switch (shape)
  {
    case CellShape::HEXAHEDRON:
      return VTK_HEXAHEDRON;
    case CellShape::WEDGE:
      return VTK_WEDGE;
    case CellShape::PYRAMID:
      return VTK_PYRAMID;
    default:
      return VTK_TETRA;
  }
}
}

Error PartitionedUnstructuredField::BuildPart(vtkUnstructuredGrid* grid, vtkDataArray* vectors,
  const std::vector<vtkDataArray*>& arrays, const FieldPartition& part)
{
  this->First = part.FirstCell;
  this->End = part.EndCell;
  const bool isEmpty = this->First == this->End;
  if (Error error =
        isEmpty ? this->SetArrays(grid, vectors, arrays) : this->BuildCells(grid, vectors, arrays))
  {
    return error;
  }
  this->SetBounds(part.FullGrid->GetBounds());
  if (isEmpty)
  {
    return {};
  }
  if (Error error = this->FindCellError(this->First))
  {
    return error;
  }
  this->FindCommonType();
  return this->GetCellPositions().FindError(this->GetNumberOfCells());
}

Error PartitionedUnstructuredField::Join(RankExchange& exchange)
{
  const auto mesh = std::make_shared<MeshLinks>();
  this->GetCellPositions().Build(this->GetNumberOfCells(), mesh->Tree,
    [&exchange](double bounds[6]) { exchange.Unite(bounds); });
  this->Boxes.Build(exchange, mesh->Tree.GetBounds());
  std::vector<vtkIdType> flat{ this->GetNumberOfFlatCells(), this->End - this->First };
  exchange.ReduceSum(flat);
  this->SetNumberOfFlatCells(flat[0]);
  if (flat[0] == flat[1])
  {
    return GetErrorWithoutCells();
  }
  if (this->First < this->End)
  {
    this->FindLinks(*mesh, false);
  }
  this->Use(mesh);
  const std::vector<vtkIdType> faces = this->GetGlobalOuterFaces();
  this->Repeated =
    SharedPoints::FindRepeated(this->GetPointsOfFaces(faces), this->GetPositions(), exchange);
  this->FindRemoteLinks(faces, *mesh, exchange);
  this->Interfaces = PartitionedInterfaces::Find(*this, this->GetGlobalOuterFaces(), exchange);
  return {};
}

std::vector<vtkIdType> PartitionedUnstructuredField::GetGlobalOuterFaces() const
{
  std::vector<vtkIdType> faces = this->GetOuterFaces();
  std::transform(faces.begin(), faces.end(), faces.begin(),
    [this](vtkIdType face) { return face + 8 * this->First; });
  return faces;
}

std::vector<vtkIdType> PartitionedUnstructuredField::GetPointsOfFaces(
  const std::vector<vtkIdType>& faces) const
{
  std::vector<vtkIdType> points;
  for (const vtkIdType face : faces)
  {
    vtkIdType corners[4];
    const int number = this->GetFacePoints(face - 8 * this->First, corners);
    points.insert(points.end(), corners, corners + number);
  }
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

void PartitionedUnstructuredField::FindRemoteLinks(
  const std::vector<vtkIdType>& own, MeshLinks& mesh, RankExchange& exchange)
{
  std::vector<BoundaryFace> outside;
  for (const vtkIdType face : own)
  {
    outside.push_back(BoundaryFace::Of(*this, face));
  }
  PartitionBoundaryFaces faces(std::move(outside), this->GetPositions(), exchange);
  if (own.empty())
  {
    return;
  }
  faces.FindLinks(true);
  this->Gaps = faces.GetMatchGaps();
  for (std::size_t i = 0; i < own.size(); ++i)
  {
    const FaceLinks::Link& link = faces.GetLinks()[i];
    if (link.Face < 0)
    {
      continue;
    }
    const BoundaryFace& other = faces.Get(link.Face);
    const auto number = static_cast<int>(other.Face % 8);
    RemoteCell remote;
    remote.Cell.Cell = other.Face / 8;
    remote.Cell.Type = GetType(other.Shape);
    remote.Link = MeshLinks::GetLink(remote.Cell.Cell, number, link);
    vtkIdType& known = mesh.Links[static_cast<std::size_t>(
      (own[i] / 8 - this->First) * mesh.FacesPerCell + own[i] % 8)];
    if (this->IsHere(remote.Cell))
    {
      known = MeshLinks::GetLink(remote.Cell.Cell - this->First, number, link);
      continue;
    }
    known = -2 - static_cast<vtkIdType>(this->RemoteCells.size());
    this->RemoteCells.push_back(remote);
  }
}

SpeedCount PartitionedUnstructuredField::CountOwnSpeeds() const
{
  return this->CountSpeeds(
    [this](vtkIdType cell, vtkIdType* points) { return this->GetConnectivity(cell, points); }, true,
    [this](vtkIdType point)
    { return !std::binary_search(this->Repeated.begin(), this->Repeated.end(), point); });
}

void PartitionedUnstructuredField::FindPatches(RankExchange& exchange)
{
  PartitionedPatches::Surface own;
  own.Faces = this->GetGlobalOuterFaces();
  const std::vector<vtkIdType> points = this->GetPointsOfFaces(own.Faces);
  for (const vtkIdType point : points)
  {
    own.Positions.emplace_back();
    this->GetPositions().Get<3>(point, own.Positions.back().data());
  }
  for (const vtkIdType face : own.Faces)
  {
    PartitionedPatches::Corners corners;
    corners.Number = this->GetFacePoints(face - 8 * this->First, corners.Points);
    for (int i = 0; i < corners.Number; ++i)
    {
      corners.Points[i] =
        std::lower_bound(points.begin(), points.end(), corners.Points[i]) - points.begin();
    }
    own.FaceCorners.push_back(corners);
  }
  this->Patches = std::make_unique<BoundaryPatches>();
  PartitionedPatches::Build(own, exchange, *this->Patches);
}

}
