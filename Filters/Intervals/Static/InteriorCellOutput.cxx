// SPDX-License-Identifier: BSD-3-Clause
#include "Static/InteriorCellOutput.h"

#include "vtkCellType.h"
#include "vtkIdList.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <vector>

namespace interlume
{

namespace
{
// Appends the interior cells one at a time, since polyhedra need face streams.
void AppendCells(vtkUnstructuredGrid* input, const ExtractionMesh& mesh,
  const std::vector<vtkIdType>& ids, vtkUnstructuredGrid* output)
{
  const vtkIdType simplices = mesh.Simplices.GetNumber();
  const vtkIdType before = mesh.Simplices.GetInteriorIdRange(0).first;
  vtkNew<vtkIdList> stream;
  vtkNew<vtkIdList> faces;
  for (vtkIdType cell = 0; cell < mesh.Simplices.GetNumberOfInteriorCells(); ++cell)
  {
    const auto range = mesh.Simplices.GetInteriorIdRange(cell);
    const vtkIdType* begin = ids.data() + (range.first - before);
    const vtkIdType* end = ids.data() + (range.second - before);
    if (mesh.InteriorCellTypes[cell] != VTK_POLYHEDRON)
    {
      output->InsertNextCell(mesh.InteriorCellTypes[cell], end - begin, begin);
      continue;
    }
    input->GetFaceStream(mesh.CellIds[simplices + cell], stream);
    faces->Reset();
    faces->InsertNextId(0);
    for (vtkIdType at = 1; at < stream->GetNumberOfIds(); at += 1 + stream->GetId(at))
    {
      const vtkIdType size = stream->GetId(at);
      // Skip degenerate faces, whose points may not be in the output.
      if (size < 3)
      {
        continue;
      }
      faces->SetId(0, faces->GetId(0) + 1);
      faces->InsertNextId(size);
      for (vtkIdType i = 1; i <= size; ++i)
      {
        const vtkIdType point = stream->GetId(at + i);
        faces->InsertNextId(
          *std::find_if(begin, end, [&](vtkIdType id) { return mesh.Points[id].Near == point; }));
      }
    }
    output->InsertNextCell(VTK_POLYHEDRON, faces);
  }
}
}

void InteriorCellOutput::SetCells(
  vtkDataSet* input, ExtractionMesh& mesh, vtkUnstructuredGrid* output)
{
  const vtkIdType simplices = mesh.Simplices.GetNumber();
  const vtkIdType interiorCells = mesh.Simplices.GetNumberOfInteriorCells();
  const unsigned char* interiorTypes = mesh.InteriorCellTypes.GetData();
  vtkNew<vtkUnsignedCharArray> types;
  types->SetNumberOfValues(simplices);
  std::fill_n(types->GetPointer(0), simplices, static_cast<unsigned char>(VTK_TETRA));
  if (std::find(interiorTypes, interiorTypes + interiorCells, VTK_POLYHEDRON) !=
    interiorTypes + interiorCells)
  {
    std::vector<vtkIdType> ids;
    for (vtkIdType at = mesh.Simplices.GetInteriorIdRange(0).first;
         at < mesh.Simplices.GetNumberOfIds(); ++at)
    {
      ids.push_back(mesh.Simplices.GetIdAt(at));
    }
    output->SetCells(types, mesh.Simplices.CopySimplices().MakeCells());
    AppendCells(vtkUnstructuredGrid::SafeDownCast(input), mesh, ids, output);
    return;
  }
  std::copy_n(interiorTypes, interiorCells, types->WritePointer(simplices, interiorCells));
  output->SetCells(types, mesh.Simplices.MakeCells());
}

}
