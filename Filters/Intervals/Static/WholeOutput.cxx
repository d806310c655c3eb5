// SPDX-License-Identifier: BSD-3-Clause
#include "Static/WholeOutput.h"

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
// Appends the whole cells one by one: polyhedra have faces besides their points.
void AppendCells(vtkUnstructuredGrid* input, const ExtractionMesh& mesh,
  const std::vector<vtkIdType>& ids, vtkUnstructuredGrid* output)
{
  const vtkIdType simplices = mesh.Simplices.GetNumber();
  const vtkIdType before = mesh.Simplices.GetWhole(0).first;
  vtkNew<vtkIdList> stream;
  vtkNew<vtkIdList> faces;
  for (vtkIdType cell = 0; cell < mesh.Simplices.GetNumberOfWhole(); ++cell)
  {
    const auto places = mesh.Simplices.GetWhole(cell);
    const vtkIdType* begin = ids.data() + (places.first - before);
    const vtkIdType* end = ids.data() + (places.second - before);
    if (mesh.WholeTypes[cell] != VTK_POLYHEDRON)
    {
      output->InsertNextCell(mesh.WholeTypes[cell], end - begin, begin);
      continue;
    }
    input->GetFaceStream(mesh.CellIds[simplices + cell], stream);
    faces->Reset();
    faces->InsertNextId(0);
    for (vtkIdType at = 1; at < stream->GetNumberOfIds(); at += 1 + stream->GetId(at))
    {
      const vtkIdType size = stream->GetId(at);
      // What has fewer points is no face, and its points are those of no cell.
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

void WholeOutput::SetCells(vtkDataSet* input, ExtractionMesh& mesh, vtkUnstructuredGrid* output)
{
  const vtkIdType simplices = mesh.Simplices.GetNumber();
  const vtkIdType whole = mesh.Simplices.GetNumberOfWhole();
  const unsigned char* wholeTypes = mesh.WholeTypes.GetData();
  vtkNew<vtkUnsignedCharArray> types;
  types->SetNumberOfValues(simplices);
  std::fill_n(types->GetPointer(0), simplices, static_cast<unsigned char>(VTK_TETRA));
  if (std::find(wholeTypes, wholeTypes + whole, VTK_POLYHEDRON) != wholeTypes + whole)
  {
    std::vector<vtkIdType> ids;
    for (vtkIdType at = mesh.Simplices.GetWhole(0).first; at < mesh.Simplices.GetNumberOfIds();
         ++at)
    {
      ids.push_back(mesh.Simplices.GetIdAt(at));
    }
    output->SetCells(types, mesh.Simplices.CopySimplices().MakeCells());
    AppendCells(vtkUnstructuredGrid::SafeDownCast(input), mesh, ids, output);
    return;
  }
  std::copy_n(wholeTypes, whole, types->WritePointer(simplices, whole));
  output->SetCells(types, mesh.Simplices.MakeCells());
}

}
