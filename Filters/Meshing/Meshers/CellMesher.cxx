// SPDX-License-Identifier: BSD-3-Clause
#include "Meshers/Meshers.h"

#include "Common/GlobalIds.h"
#include "Common/Vectors.h"
#include "Shells/CellDecomposition.h"
#include "Shells/CellShell.h"
#include "Shells/CollapsedPoints.h"
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

/// Returns whether a cell is decomposed, and counts it if it is skipped.
bool IsMeshed(vtkIdType cell, MeshingJob& job)
{
  const int type = job.Input->GetCellType(cell);
  if (!CellShell::IsSupported(type))
  {
    vtkIdType& count =
      MeshingJob::GetDimension(type) == 3 ? job.Report.UnsupportedCells : job.Report.SkippedCells;
    ++count;
    return false;
  }
  constexpr unsigned char leftOut =
    vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::HIDDENCELL;
  vtkUnsignedCharArray* ghosts = job.Input->GetCellGhostArray();
  if (ghosts && (ghosts->GetValue(cell) & leftOut))
  {
    ++job.Report.SkippedCells;
    return false;
  }
  return true;
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
  const vtkIdType number = input->GetNumberOfCells();
  std::vector<vtkIdType> cells;
  for (vtkIdType cell = 0; cell < number; ++cell)
  {
    if (IsMeshed(cell, job))
    {
      cells.push_back(cell);
    }
  }
  job.Report.Cells = static_cast<vtkIdType>(cells.size());
  const std::vector<vtkIdType> merged =
    CollapsedPoints::Find(input, cells, triangulation.GetOrder(), job.Report.MergedPoints);
  CopyPoints(input, job.Mesh);
  Error firstError;
  vtkIdType firstErrorCell = -1;
  vtkIdType errors = 0;
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    if (i % 256 == 0)
    {
      job.SetProgress(0.9 * static_cast<double>(i) / static_cast<double>(cells.size()));
    }
    if (job.IsCanceled())
    {
      return {};
    }
    CellShell shell;
    CellDecomposition decomposition(shell);
    Error error = shell.Take(input, cells[i], triangulation, merged);
    for (int face = 0; face < shell.NumberOfFoldedFaces; ++face)
    {
      job.Report.AddFoldedFace(cells[i]);
    }
    // After an error, only count the cells that are invalid too.
    error = errors > 0 ? error : error.Then([&] { return decomposition.Execute(job); });
    if (!error)
    {
      AddCell(cells[i], shell, decomposition, job.Mesh);
    }
    else if (errors++ == 0)
    {
      firstError = error;
      firstErrorCell = cells[i];
    }
  }
  job.Mesh.RemoveUnusedPoints();
  return firstError.Within("Cell " + std::to_string(firstErrorCell) + " cannot be decomposed: ",
    errors > 1
      ? ". At least " + std::to_string(errors) + " cells have errors. Correct or remove them."
      : ". Correct or remove the cell.");
}

}
