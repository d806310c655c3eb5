// SPDX-License-Identifier: BSD-3-Clause
#include "Meshers/Meshers.h"

#include "Common/GlobalIds.h"
#include "Common/Vectors.h"
#include "Shells/CellDecomposition.h"
#include "Shells/CellShell.h"
#include "Shells/FaceTriangulation.h"
#include "TetGen/MeshingJob.h"

#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace interlume
{

namespace
{
FaceTriangulation MakeTriangulation(vtkDataSet* input)
{
  const vtkSmartPointer<GlobalIds::Array> globalIds = GlobalIds::Get(input->GetPointData());
  return FaceTriangulation(
    [input](vtkIdType p)
    {
      glm::dvec3 x;
      input->GetPoint(p, glm::value_ptr(x));
      return x;
    },
    [globalIds](vtkIdType a, vtkIdType b)
    {
      const vtkIdType first = globalIds ? globalIds->GetValue(a) : a;
      const vtkIdType second = globalIds ? globalIds->GetValue(b) : b;
      return first < second || (first == second && a < b);
    });
}

/// Copies the input points to the mesh. Points that are added later follow them.
void CopyPoints(vtkDataSet* input, interlume::Tetrahedra& mesh)
{
  const vtkIdType number = input->GetNumberOfPoints();
  mesh.Points.resize(3 * number);
  mesh.Origins.resize(number);
  for (vtkIdType p = 0; p < number; ++p)
  {
    input->GetPoint(p, &mesh.Points[3 * p]);
    mesh.Origins[p].NumberOfSources = 1;
    mesh.Origins[p].Sources[0] = p;
  }
}

void AddCell(vtkIdType cell, const CellShell& shell, const CellDecomposition& decomposition,
  interlume::Tetrahedra& mesh)
{
  const int given = static_cast<int>(shell.PointIds.size());
  const auto firstNew = static_cast<vtkIdType>(mesh.Origins.size());
  mesh.Points.insert(
    mesh.Points.end(), decomposition.NewPoints.begin(), decomposition.NewPoints.end());
  mesh.Origins.resize(mesh.Points.size() / 3);
  for (const auto& tetrahedron : decomposition.Tetrahedra)
  {
    for (int point : tetrahedron)
    {
      mesh.Tetrahedra.push_back(point < given ? shell.PointIds[point] : firstNew + point - given);
    }
    mesh.Cells.push_back(cell);
  }
}
}

Error Meshers::MeshCells(MeshingJob& job)
{
  vtkDataSet* input = job.Input;
  if (Error error = ArrayCheck::MakeSentence(GlobalIds::FindError(input)))
  {
    return error;
  }
  const FaceTriangulation triangulation = MakeTriangulation(input);
  vtkUnsignedCharArray* ghosts = input->GetCellGhostArray();
  constexpr unsigned char leftOut =
    vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::HIDDENCELL;
  CopyPoints(input, job.Mesh);
  const vtkIdType number = input->GetNumberOfCells();
  for (vtkIdType cell = 0; cell < number; ++cell)
  {
    if (cell % 256 == 0)
    {
      job.SetProgress(0.9 * static_cast<double>(cell) / static_cast<double>(number));
    }
    if (job.IsCanceled())
    {
      return {};
    }
    const int type = input->GetCellType(cell);
    if (!CellShell::IsSupported(type))
    {
      vtkIdType& count =
        MeshingJob::GetDimension(type) == 3 ? job.Report.UnsupportedCells : job.Report.SkippedCells;
      ++count;
      continue;
    }
    if (ghosts && (ghosts->GetValue(cell) & leftOut))
    {
      ++job.Report.SkippedCells;
      continue;
    }
    ++job.Report.Cells;
    CellShell shell;
    CellDecomposition decomposition(shell);
    if (const Error error =
          shell.Take(input, cell, triangulation).Then([&] { return decomposition.Execute(job); }))
    {
      return error.Within("Cell " + std::to_string(cell) + " cannot be decomposed: ", ".");
    }
    AddCell(cell, shell, decomposition, job.Mesh);
  }
  job.Mesh.RemoveUnusedPoints();
  return {};
}

}
