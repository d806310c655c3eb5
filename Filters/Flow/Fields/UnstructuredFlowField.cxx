// SPDX-License-Identifier: BSD-3-Clause
#include "Fields/UnstructuredFlowField.h"

#include "Cells/MultilinearCell.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>

namespace interlume
{

Error UnstructuredFlowField::Build(vtkUnstructuredGrid* grid, vtkDataArray* vectors,
  const std::vector<vtkDataArray*>& arrays, const StageProgress& progress)
{
  static_assert(VTK_TETRA == FirstType && VTK_VOXEL == FirstType + 1 &&
      VTK_HEXAHEDRON == FirstType + 2 && VTK_WEDGE == FirstType + 3 && VTK_PYRAMID == FirstType + 4,
    "the types are in this order");
  if (grid->GetNumberOfCells() == 0 || !grid->GetPoints())
  {
    return GetErrorWithoutCells();
  }
  if (Error error = this->BuildCells(grid, vectors, arrays))
  {
    return error;
  }
  // If the links are cached, the cells have been validated before.
  const MeshLinks::Key key = MeshLinks::GetKey(grid);
  const std::shared_ptr<const MeshLinks> cached = MeshLinks::Find(key);
  if (this->GetNumberOfFlatCells() == this->GetNumberOfCells())
  {
    return GetErrorWithoutCells();
  }
  Error error = cached ? Error() : this->FindCellError(0);
  if (error || !progress.Reach(0.1))
  {
    return error;
  }
  this->FindCommonType();
  this->Measure(
    [this](vtkIdType cell, vtkIdType* ids) { return this->GetConnectivity(cell, ids); }, true);
  if (!progress.Reach(0.2))
  {
    return {};
  }
  if (cached)
  {
    this->Use(cached);
    this->NumberOfReusedFaceMatches = static_cast<vtkIdType>(cached->Links.size());
    // Report progress, and check for abort, at the same steps as if nothing were cached.
    if (progress.Reach(0.3))
    {
      progress.Reach(0.6);
    }
    return {};
  }
  const auto mesh = std::make_shared<MeshLinks>();
  const CellPositions positions = this->GetCellPositions();
  error = positions.FindError(this->GetNumberOfCells());
  if (!error && progress.Reach(0.3))
  {
    positions.Build(this->GetNumberOfCells(), mesh->Tree);
    if (progress.Reach(0.6))
    {
      this->FindLinks(*mesh, true);
      MeshLinks::Add(key, mesh);
    }
  }
  this->Use(mesh);
  return error;
}

Error UnstructuredFlowField::BuildCells(
  vtkUnstructuredGrid* grid, vtkDataArray* vectors, const std::vector<vtkDataArray*>& arrays)
{
  if (Error error = this->SetArrays(grid, vectors, arrays))
  {
    return error;
  }
  this->Offsets.Build(grid->GetCells()->GetOffsetsArray());
  this->PointIds.Build(grid->GetCells()->GetConnectivityArray());
  this->TypeArray = GridCells::GetTypes(grid);
  this->Types = this->TypeArray->GetPointer(0);
  this->Positions.Build(grid->GetPoints()->GetData());
  this->SetBlanking(
    grid, [this](vtkIdType cell, vtkIdType* ids) { return this->GetConnectivity(cell, ids); });
  this->ExcludeFlatCells();
  return {};
}

int UnstructuredFlowField::GetConnectivity(vtkIdType cell, vtkIdType* points) const
{
  const vtkIdType first = this->Offsets.Get(cell);
  const vtkIdType number = std::min<vtkIdType>(this->Offsets.Get(cell + 1) - first, 8);
  for (vtkIdType v = 0; v < number; ++v)
  {
    points[v] = this->PointIds.Get(first + v);
  }
  return static_cast<int>(number);
}

CellPositions UnstructuredFlowField::GetCellPositions() const
{
  return CellPositions(this->Positions,
    [this](vtkIdType cell, vtkIdType* ids) { return this->GetCellPoints(cell, ids); });
}

void UnstructuredFlowField::ExcludeFlatCells()
{
  std::array<bool, 256> isFlat{};
  for (int type = 0; type < 256; ++type)
  {
    isFlat[static_cast<std::size_t>(type)] =
      GetCorners(type).Number == 0 && MultilinearCell::IsFlat(type);
  }
  for (vtkIdType cell = 0; cell < this->GetNumberOfCells(); ++cell)
  {
    if (isFlat[this->Types[cell]] && this->IsCellIncluded(cell))
    {
      this->ExcludeFlatCell(cell);
    }
  }
}

void UnstructuredFlowField::FindCommonType()
{
  const vtkIdType number = this->GetNumberOfCells();
  const int size = GetCorners(this->Types[0]).Number;
  const bool isOnly = std::all_of(this->Types, this->Types + number,
                        [this](unsigned char type) { return type == this->Types[0]; }) &&
    this->Offsets.Get(number) == number * size;
  this->OnlyType = isOnly ? this->Types[0] : 0;
  this->OnlySize = isOnly ? size : 0;
}

Error UnstructuredFlowField::FindCellError(vtkIdType first) const
{
  for (vtkIdType cell = 0; cell < this->GetNumberOfCells(); ++cell)
  {
    const int expected = GetCorners(this->Types[cell]).Number;
    const vtkIdType found = this->Offsets.Get(cell + 1) - this->Offsets.Get(cell);
    if (!this->IsCellIncluded(cell) || (expected > 0 && found == expected))
    {
      continue;
    }
    const std::string which = "cell " + std::to_string(first + cell) + " is a " +
      GridCells::GetClassName(this->Types[cell]) + " (type " + std::to_string(this->Types[cell]) +
      ")";
    return expected == 0
      ? which + "; only tetrahedra, voxels, hexahedra, wedges and pyramids are supported"
      : which + " with " + std::to_string(found) + " points";
  }
  return {};
}

int UnstructuredFlowField::GetCellPoints(vtkIdType cell, vtkIdType* points) const
{
  if (!this->IsCellIncluded(cell))
  {
    return 0;
  }
  const CellLocation location = this->GetCellLocation(cell);
  this->ForEachCorner(location, [points](int corner, vtkIdType point) { points[corner] = point; });
  return GetCorners(location.Type).Number;
}

void UnstructuredFlowField::Use(const std::shared_ptr<const MeshLinks>& mesh)
{
  this->Mesh = mesh;
  this->FacesPerCell = mesh->FacesPerCell;
  this->Links = mesh->Links.data();
}

void UnstructuredFlowField::FillFaces(vtkIdType cell, FaceLinks::Block& faces) const
{
  vtkIdType points[8];
  const bool isIncluded = this->GetCellPoints(cell, points) > 0;
  const CellShape& shape = CellShape::Of(GetCorners(this->Types[cell]).Shape);
  const int number = isIncluded ? shape.NumberOfFaces : 0;
  for (int i = 0; i < FaceLinks::MaximumPerBlock; ++i)
  {
    faces.Corners[i] = i < number ? shape.Faces[i].NumberOfCorners : 0;
    for (int corner = 0; corner < faces.Corners[i]; ++corner)
    {
      faces.Points[i][corner] = points[shape.Faces[i].Corners[corner]];
    }
  }
}

std::vector<vtkIdType> UnstructuredFlowField::GetOuterFaces() const
{
  std::vector<vtkIdType> faces;
  for (vtkIdType cell = 0; cell < this->GetNumberOfCells(); ++cell)
  {
    const int number = this->IsCellIncluded(cell)
      ? CellShape::Of(GetCorners(this->Types[cell]).Shape).NumberOfFaces
      : 0;
    for (int face = 0; face < number; ++face)
    {
      if (this->GetLink(cell, face) == -1)
      {
        faces.push_back(8 * cell + face);
      }
    }
  }
  return faces;
}

int UnstructuredFlowField::GetFacePoints(vtkIdType face, vtkIdType* points) const
{
  FaceLinks::Block faces;
  this->FillFaces(face / 8, faces);
  const auto number = static_cast<int>(face % 8);
  std::copy_n(faces.Points[number], faces.Corners[number], points);
  return faces.Corners[number];
}

int UnstructuredFlowField::FindFacesPerCell() const
{
  int maximum = 4;
  for (vtkIdType cell = 0; cell < this->GetNumberOfCells(); ++cell)
  {
    if (this->IsCellIncluded(cell))
    {
      const int shape = GetCorners(this->Types[cell]).Shape;
      maximum = std::max(maximum, CellShape::Of(shape).NumberOfFaces);
    }
  }
  return maximum;
}

void UnstructuredFlowField::FindLinks(MeshLinks& mesh, bool byCoordinates) const
{
  const int facesPerCell = this->FindFacesPerCell();
  mesh.FacesPerCell = facesPerCell;
  mesh.Links.assign(this->GetNumberOfCells() * facesPerCell, -1);
  const auto fill = [this](vtkIdType cell, FaceLinks::Block& faces)
  { this->FillFaces(cell, faces); };
  const auto set = [&mesh, facesPerCell](vtkIdType face, const FaceLinks::Link& link)
  {
    mesh.Links[face] = MeshLinks::GetLink(
      link.Face / facesPerCell, static_cast<int>(link.Face % facesPerCell), link);
  };
  if (!byCoordinates)
  {
    FaceLinks::FindByPoints(
      this->GetNumberOfCells(), facesPerCell, fill, this->Positions.GetNumber(), set);
    return;
  }
  mesh.Gaps = FaceLinks::Find(
    this->GetNumberOfCells(), facesPerCell, fill,
    [this, facesPerCell](vtkIdType face, vtkIdType* points)
    { return this->GetCellPoints(face / facesPerCell, points); },
    this->Positions, set);
}

}
