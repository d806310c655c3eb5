// SPDX-License-Identifier: BSD-3-Clause
// What goes on, but not as it should, is said with the way out: polyhedra that are not seen whole
// from their middle, and images that single precision collapses.
#include "Reference/Checks/ReferenceCheck.h"
#include "Reference/Checks/ReferenceMessages.h"
#include "Reference/Meshes/ReferenceField.h"
#include "Reference/Meshes/ReferenceMesh.h"
#include "Reference/Meshes/ReferenceVolume.h"
#include "Reference/TimeVarying/ReferenceTimeVarying.h"

#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkIntervalVolume.h"
#include "vtkIsotableContour.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkRectilinearGrid.h"
#include "vtkUnstructuredGrid.h"

namespace
{

using namespace reference;

bool Says(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

/// A prism over an outline in the plane, counterclockwise, as one polyhedron.
vtkSmartPointer<vtkUnstructuredGrid> MakePrism(const std::vector<std::array<double, 2>>& outline)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  const vtkIdType n = static_cast<vtkIdType>(outline.size());
  for (double z : { 0.0, 1.0 })
  {
    for (const auto& x : outline)
    {
      points->InsertNextPoint(x[0], x[1], z);
    }
  }
  grid->SetPoints(points);
  std::vector<vtkIdType> stream = { n };
  for (vtkIdType i = n; i-- > 0;)
  {
    stream.push_back(i);
  }
  stream.push_back(n);
  for (vtkIdType i = 0; i < n; ++i)
  {
    stream.push_back(n + i);
  }
  std::vector<vtkIdType> ids(2 * n);
  for (vtkIdType i = 0; i < n; ++i)
  {
    const vtkIdType next = (i + 1) % n;
    stream.insert(stream.end(), { 4, i, next, n + next, n + i });
    ids[i] = i;
    ids[n + i] = n + i;
  }
  grid->InsertNextCell(VTK_POLYHEDRON, 2 * n, ids.data(), n + 2, stream.data());
  AddIntegerField(grid, 1, 1);
  return grid;
}

void CheckConcave(Check& check)
{
  // A U of seven squares, and a hexagon.
  const auto concave =
    MakePrism({ { 0, 0 }, { 3, 0 }, { 3, 3 }, { 2, 3 }, { 2, 1 }, { 1, 1 }, { 1, 3 }, { 0, 3 } });
  const auto convex = MakePrism({ { 0, 0 }, { 2, 0 }, { 3, 1 }, { 3, 2 }, { 1, 2 }, { 0, 1 } });
  vtkNew<vtkIntervalVolume> filter;
  filter->SetInterval(0, -1, 1);
  filter->SetInputData(concave);
  const std::string said = WarningsOf(filter);
  check.That(Says(said, "1 polyhedra are not seen whole") && Says(said, "convex cells"),
    "a concave polyhedron is told of: " + said);
  check.Equal(filter->GetReport().ConcavePolyhedra, 1, "concave polyhedra");
  check.That(MeasureTetrahedra(filter->GetOutput()).SumOfAbsolute > 7.5, "its parts overlap");
  filter->SetInterval(0, -1, 2);
  check.That(Says(WarningsOf(filter), "not seen whole"), "and again from the grid that is kept");
  filter->SetInputData(convex);
  check.That(WarningsOf(filter).empty(), "a convex one is not");
  check.Equal(filter->GetReport().ConcavePolyhedra, 0, "convex polyhedra");
  vtkNew<vtkIsotableContour> contour;
  contour->SetValue(0, 0.5);
  contour->WarnOnEmptyOutputOff();
  contour->SetInputData(concave);
  check.That(Says(WarningsOf(contour), "not seen whole"), "a contour tells of it");
  const TimeVaryingPipeline pipeline(RepeatGrid(concave, { 0, 1 }), { { { -1, 1 } } });
  check.That(Says(WarningsOf(pipeline.Filter), "not seen whole"), "and in time");
}

void CheckFar(Check& check)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(4, 4, 4);
  AddRandomField(image, 1);
  vtkNew<vtkIntervalVolume> filter;
  filter->SetInterval(0, 0.25, 0.75);
  filter->SetInputData(image);
  const auto said = [&](double origin, double spacing, int precision)
  {
    image->SetOrigin(origin, 0, 0);
    image->SetSpacing(spacing, spacing, spacing);
    filter->SetOutputPointsPrecision(precision);
    return WarningsOf(filter);
  };
  const std::string far = said(1e9, 1, vtkAlgorithm::DEFAULT_PRECISION);
  check.That(Says(far, "single precision") && Says(far, "OutputPointsPrecision"),
    "an image at 1e9 is told of: " + far);
  check.That(said(1e9, 1, vtkAlgorithm::DOUBLE_PRECISION).empty(), "not in double");
  check.That(said(1e4, 1, vtkAlgorithm::DEFAULT_PRECISION).empty(), "nor at 1e4");
  check.That(!said(1e4, 1e-3, vtkAlgorithm::DEFAULT_PRECISION).empty(), "but with small cells");
  vtkNew<vtkRectilinearGrid> grid;
  grid->SetDimensions(4, 4, 4);
  vtkNew<vtkDoubleArray> axis;
  for (int i = 0; i < 4; ++i)
  {
    axis->InsertNextValue(1e9 + i);
  }
  grid->SetXCoordinates(axis);
  grid->SetYCoordinates(axis);
  grid->SetZCoordinates(axis);
  AddRandomField(grid, 1);
  filter->SetInputData(grid);
  filter->SetOutputPointsPrecision(vtkAlgorithm::DEFAULT_PRECISION);
  check.That(WarningsOf(filter).empty(), "a grid of doubles keeps them");
  filter->SetOutputPointsPrecision(vtkAlgorithm::SINGLE_PRECISION);
  check.That(Says(WarningsOf(filter), "single precision"), "unless told otherwise");
  image->SetOrigin(1e9, 0, 0);
  image->SetSpacing(1, 1, 1);
  TimeVaryingSettings settings = { { { 0.25, 0.75 } } };
  const TimeVaryingPipeline pipeline(RepeatGrid(image, { 0, 1 }), settings);
  pipeline.Filter->SetOutputPointsPrecision(vtkAlgorithm::DEFAULT_PRECISION);
  check.That(Says(WarningsOf(pipeline.Filter), "single precision"), "and in time");
}

}

int TestIntervalVolumeWarnings(int, char*[])
{
  Check check;
  check.SetContext("concave polyhedra");
  CheckConcave(check);
  check.SetContext("far from the origin");
  CheckFar(check);
  return check.Result();
}
