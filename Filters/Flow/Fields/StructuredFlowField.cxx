// SPDX-License-Identifier: BSD-3-Clause
#include "Fields/StructuredFlowField.h"

#include "vtkPoints.h"
#include "vtkStructuredGrid.h"

namespace interlume
{

Error StructuredFlowField::Build(vtkStructuredGrid* grid, vtkDataArray* vectors,
  const std::vector<vtkDataArray*>& arrays, const StageProgress& progress,
  const FieldPartition* part)
{
  int points[3];
  grid->GetDimensions(points);
  Error error =
    this->BuildTopologyAndArrays(grid, points, vectors, arrays, progress.GetPart(0.0, 0.2), part);
  if (error || !progress.Reach(0.2) || this->GetNumberOfCells() == 0)
  {
    return error;
  }
  this->Positions.Build(grid->GetPoints()->GetData());
  error = this->GetCellPositions().FindError(this->GetNumberOfCells());
  if (!error && !part && progress.Reach(0.3))
  {
    this->BuildTree();
    if (progress.Reach(0.9))
    {
      this->FindSeams();
    }
  }
  return error;
}

CellPositions StructuredFlowField::GetCellPositions(
  const std::function<bool(const CellLocation&)>& isCounted) const
{
  return CellPositions(this->Positions,
    [this, isCounted](vtkIdType cell, vtkIdType* ids)
    {
      const bool isPart = FlowField::IsCellIncluded(cell) &&
        (!isCounted || isCounted(this->GetHeldCellLocation(cell)));
      return isPart ? this->GetLocalCellPoints(cell, ids) : 0;
    });
}

void StructuredFlowField::BuildTree(
  const std::function<bool(const CellLocation&)>& isCounted, const CellTree::Unite& unite)
{
  this->GetCellPositions(isCounted).Build(this->GetNumberOfCells(), this->Tree, unite);
}

std::vector<vtkIdType> StructuredFlowField::GetBoundaryFaces(
  const int first[3], const int last[3]) const
{
  std::vector<vtkIdType> faces;
  for (int face = 0; face < 6; ++face)
  {
    const int axis = face >> 1;
    const int across[2] = { (axis + 1) % 3, (axis + 2) % 3 };
    int index[3];
    index[axis] = face & 1 ? this->Cells[axis] - 1 : 0;
    if (index[axis] < first[axis] || index[axis] > last[axis])
    {
      continue;
    }
    for (index[across[1]] = first[across[1]]; index[across[1]] <= last[across[1]];
         ++index[across[1]])
    {
      for (index[across[0]] = first[across[0]]; index[across[0]] <= last[across[0]];
           ++index[across[0]])
      {
        const vtkIdType cell = this->GetCellLocation(index).Cell;
        if (this->IsCellIncluded(cell))
        {
          faces.push_back(8 * cell + face);
        }
      }
    }
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

std::vector<vtkIdType> StructuredFlowField::GetBoundaryFaces() const
{
  const int first[3] = { 0, 0, 0 };
  const int last[3] = { this->Cells[0] - 1, this->Cells[1] - 1, this->Cells[2] - 1 };
  return this->GetBoundaryFaces(first, last);
}

std::vector<vtkIdType> StructuredFlowField::RemoveSeamFaces(std::vector<vtkIdType> faces) const
{
  const auto isSeam = [this](vtkIdType face)
  { return this->FindSeam(face / 8, static_cast<int>(face % 8)) != nullptr; };
  faces.erase(std::remove_if(faces.begin(), faces.end(), isSeam), faces.end());
  return faces;
}

int StructuredFlowField::GetFacePoints(vtkIdType face, vtkIdType* points) const
{
  const CellLocation location = this->GetCellLocation(face / 8);
  const int* corners = CellShape::Of(CellShape::HEXAHEDRON).Faces[face % 8].Corners;
  for (int i = 0; i < 4; ++i)
  {
    points[i] = this->GetCorner(location, corners[i]);
  }
  return 4;
}

void StructuredFlowField::FindSeams()
{
  const std::vector<vtkIdType> faces = this->GetBoundaryFaces();
  std::vector<FaceLinks::Link> links(faces.size(), FaceLinks::Link{ -1, 0, false });
  const FaceLinks::MatchGaps gaps = FaceLinks::Find(
    static_cast<vtkIdType>(faces.size()), 1,
    [&](vtkIdType i, FaceLinks::Block& block)
    { block.Corners[0] = this->GetFacePoints(faces[i], block.Points[0]); },
    [&](vtkIdType i, vtkIdType* points)
    {
      const CellLocation location = this->GetCellLocation(faces[i] / 8);
      for (int corner = 0; corner < 8; ++corner)
      {
        points[corner] = this->GetCorner(location, corner);
      }
      return 8;
    },
    this->Positions, [&](vtkIdType i, const FaceLinks::Link& link) { links[i] = link; });
  this->SetSeams(GetSeams(faces, faces, links), gaps);
}

std::vector<StructuredFlowField::Seam> StructuredFlowField::GetSeams(
  const std::vector<vtkIdType>& own, const std::vector<vtkIdType>& all,
  const std::vector<FaceLinks::Link>& links)
{
  std::vector<Seam> seams;
  for (std::size_t i = 0; i < own.size(); ++i)
  {
    if (links[i].Face >= 0)
    {
      seams.push_back({ own[i], links[i] });
      seams.back().Link.Face = all[static_cast<std::size_t>(links[i].Face)];
    }
  }
  return seams;
}

const StructuredFlowField::Seam* StructuredFlowField::FindSeam(vtkIdType cell, int face) const
{
  const vtkIdType key = 8 * cell + face;
  const auto found = std::lower_bound(this->Seams.begin(), this->Seams.end(), key,
    [](const Seam& seam, vtkIdType value) { return seam.Face < value; });
  return found != this->Seams.end() && found->Face == key ? &*found : nullptr;
}

bool StructuredFlowField::CrossSeam(CellLocation& location, int face, double p[3]) const
{
  const Seam* seam = this->FindSeam(location.Cell, face);
  if (!seam)
  {
    return false;
  }
  const auto& faces = CellShape::Of(CellShape::HEXAHEDRON).Faces;
  double uv[2];
  faces[face].GetParameters(p, uv);
  FaceLinks::Map(4, seam->Link.Start, seam->Link.IsReversed, uv);
  faces[seam->Link.Face % 8].GetCoordinates(uv, p);
  location = this->GetCellLocation(seam->Link.Face / 8);
  return true;
}

}
