// SPDX-License-Identifier: BSD-3-Clause
// Together, the pieces of an image that are requested through the pipeline yield the simplices of
// the full image.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Meshes/ReferenceGrid.h"

#include "vtkIntervalVolume.h"
#include "vtkIsotableContour.h"
#include "vtkNew.h"
#include "vtkRTAnalyticSource.h"
#include "vtkUnstructuredGrid.h"

namespace
{

using namespace reference;

std::vector<GeometricSimplex> Collect(
  vtkUnstructuredGridAlgorithm* filter, int port, int pieces, const std::string& array)
{
  std::vector<GeometricSimplex> all;
  for (int piece = 0; piece < pieces; ++piece)
  {
    filter->UpdatePiece(piece, pieces, 0);
    const auto part =
      GeometricSet(vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(port)), { array });
    all.insert(all.end(), part.begin(), part.end());
  }
  std::sort(all.begin(), all.end());
  return all;
}

}

int TestIntervalVolumePieces(int, char*[])
{
  Check check;
  vtkNew<vtkRTAnalyticSource> source;
  source->SetWholeExtent(-6, 6, -5, 7, -6, 6);
  vtkNew<vtkIntervalVolume> volume;
  volume->SetInputConnection(source->GetOutputPort());
  volume->SetInterval(0, 120, 160);
  volume->SetInterval(1, 160, 210);
  volume->GenerateBoundariesOn();
  vtkNew<vtkIntervalVolume> whole;
  whole->SetInputConnection(source->GetOutputPort());
  whole->SetInterval(0, 120, 160);
  whole->SetInterval(1, 160, 210);
  whole->GenerateBoundariesOn();
  whole->KeepInteriorCellsOn();
  vtkNew<vtkIsotableContour> contour;
  contour->SetInputConnection(source->GetOutputPort());
  contour->SetValue(0, 157);

  const auto tetrahedra = Collect(volume, 0, 1, "IntervalId");
  const auto triangles = Collect(volume, 1, 1, "BoundarySide");
  const auto cells = Collect(whole, 0, 1, "IntervalId");
  const auto surface = Collect(contour, 0, 1, "ContourId");
  check.That(!tetrahedra.empty() && !triangles.empty() && !cells.empty() && !surface.empty(),
    "the output is not empty");
  for (int pieces : { 2, 3, 8 })
  {
    check.SetContext(std::to_string(pieces) + " pieces");
    check.That(Collect(volume, 0, pieces, "IntervalId") == tetrahedra, "the tetrahedra");
    check.That(Collect(volume, 1, pieces, "BoundarySide") == triangles, "the boundary triangles");
    check.That(Collect(whole, 0, pieces, "IntervalId") == cells, "tetrahedra and interior cells");
    check.That(Collect(whole, 1, pieces, "BoundarySide") == triangles,
      "the boundary triangles with interior cells");
    check.That(Collect(contour, 0, pieces, "ContourId") == surface, "the contour");
  }
  return check.Result();
}
