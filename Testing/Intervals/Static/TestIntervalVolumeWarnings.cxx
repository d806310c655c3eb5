// SPDX-License-Identifier: BSD-3-Clause
// Problems that do not stop the execution are warnings that name a remedy, for example polyhedra
// that are not visible from their center and images that degenerate in single precision.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceMessages.h"
#include "Support/Checks/ReferenceReport.h"
#include "Support/Meshes/ReferenceField.h"
#include "Support/Meshes/ReferenceMesh.h"
#include "Support/Meshes/ReferenceMeshBuilder.h"
#include "Support/Meshes/ReferenceVolume.h"
#include "Support/TimeVarying/ReferenceTimeVarying.h"

#include "vtkAMRBox.h"
#include "vtkAMRUtilities.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkIntervalVolume.h"
#include "vtkIsotableContour.h"
#include "vtkNew.h"
#include "vtkOverlappingAMR.h"
#include "vtkPoints.h"
#include "vtkRectilinearGrid.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStructuredGrid.h"
#include "vtkTimeVaryingIntervalVolume.h"
#include "vtkTrivialProducer.h"
#include "vtkUniformGrid.h"
#include "vtkUnstructuredGrid.h"

namespace
{

using namespace reference;

bool Contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

/// Returns a prism over a counterclockwise polygon as one polyhedron.
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
  // A U-shaped polygon of seven squares, and a hexagon.
  const auto concave =
    MakePrism({ { 0, 0 }, { 3, 0 }, { 3, 3 }, { 2, 3 }, { 2, 1 }, { 1, 1 }, { 1, 3 }, { 0, 3 } });
  const auto convex = MakePrism({ { 0, 0 }, { 2, 0 }, { 3, 1 }, { 3, 2 }, { 1, 2 }, { 0, 1 } });
  vtkNew<vtkIntervalVolume> filter;
  filter->SetInterval(0, -1, 1);
  filter->SetInputData(concave);
  const std::string warning = WarningsOf(filter);
  check.That(Contains(warning, "1 polyhedra cannot be split") && Contains(warning, "convex cells"),
    "a warning for a concave polyhedron: " + warning);
  check.Equal(filter->GetReport()->GetCount("ConcavePolyhedra"), 1, "concave polyhedra");
  check.That(MeasureTetrahedra(filter->GetOutput()).SumOfAbsolute > 7.5,
    "tetrahedra of a concave polyhedron overlap");
  filter->SetInterval(0, -1, 2);
  check.That(
    Contains(WarningsOf(filter), "cannot be split"), "the warning is repeated for the cached grid");
  filter->SetInputData(convex);
  check.That(WarningsOf(filter).empty(), "no warning for a convex polyhedron");
  check.Equal(filter->GetReport()->GetCount("ConcavePolyhedra"), 0,
    "number of concave polyhedra for a convex polyhedron");
  vtkNew<vtkIsotableContour> contour;
  contour->SetValue(0, 0.5);
  contour->WarnOnEmptyOutputOff();
  contour->SetInputData(concave);
  check.That(Contains(WarningsOf(contour), "cannot be split"), "the contour warns too");
  const TimeVaryingPipeline pipeline(RepeatGrid(concave, { 0, 1 }), { { { -1, 1 } } });
  check.That(
    Contains(WarningsOf(pipeline.Filter), "cannot be split"), "the time-varying filter warns too");
}

void CheckFar(Check& check)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(4, 4, 4);
  AddRandomField(image, 1);
  vtkNew<vtkIntervalVolume> filter;
  filter->SetInterval(0, 0.25, 0.75);
  filter->SetInputData(image);
  const auto warning = [&](double origin, double spacing, int precision)
  {
    image->SetOrigin(origin, 0, 0);
    image->SetSpacing(spacing, spacing, spacing);
    filter->SetOutputPointsPrecision(precision);
    return WarningsOf(filter);
  };
  const std::string far = warning(1e9, 1, vtkAlgorithm::DEFAULT_PRECISION);
  check.That(Contains(far, "single precision") && Contains(far, "OutputPointsPrecision"),
    "a warning for an image at 1e9: " + far);
  check.That(
    warning(1e9, 1, vtkAlgorithm::DOUBLE_PRECISION).empty(), "no warning in double precision");
  check.That(warning(1e4, 1, vtkAlgorithm::DEFAULT_PRECISION).empty(), "no warning at 1e4");
  check.That(!warning(1e4, 1e-3, vtkAlgorithm::DEFAULT_PRECISION).empty(),
    "a warning at 1e4 with small cells");
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
  check.That(WarningsOf(filter).empty(), "no warning for a grid with double coordinates");
  filter->SetOutputPointsPrecision(vtkAlgorithm::SINGLE_PRECISION);
  check.That(Contains(WarningsOf(filter), "single precision"),
    "a warning for double coordinates with single-precision output");
  image->SetOrigin(1e9, 0, 0);
  image->SetSpacing(1, 1, 1);
  TimeVaryingSettings settings = { { { 0.25, 0.75 } } };
  const TimeVaryingPipeline pipeline(RepeatGrid(image, { 0, 1 }), settings);
  pipeline.Filter->SetOutputPointsPrecision(vtkAlgorithm::DEFAULT_PRECISION);
  check.That(
    Contains(WarningsOf(pipeline.Filter), "single precision"), "the time-varying filter warns too");
}

/// The warnings and reports of several filters.
struct Warned
{
  std::vector<std::string> Texts;
  std::vector<ReportCopy> Reports;
};

Warned WarnAll(vtkDataObject* data, double upper)
{
  Warned warned;
  vtkNew<vtkIntervalVolume> volume;
  volume->SetInterval(0, -1.0, upper);
  vtkNew<vtkIntervalVolume> whole;
  whole->SetInterval(0, -1.0, upper);
  whole->KeepInteriorCellsOn();
  vtkNew<vtkIsotableContour> contour;
  contour->SetValue(0, upper);
  vtkNew<vtkIsotableContour> soup;
  soup->SetValue(0, upper);
  soup->MergePointsOff();
  for (vtkIntervalVolume* filter : { volume.Get(), whole.Get() })
  {
    filter->SetInputDataObject(data);
    warned.Texts.push_back(WarningsOf(filter));
    warned.Reports.push_back(filter->GetReport());
  }
  for (vtkIsotableContour* filter : { contour.Get(), soup.Get() })
  {
    filter->SetInputDataObject(data);
    warned.Texts.push_back(WarningsOf(filter));
    warned.Reports.push_back(filter->GetReport());
  }
  // The same data at two time steps.
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(data);
  const double times[] = { 0.0, 1.0 };
  producer->GetOutputInformation(0)->Set(vtkStreamingDemandDrivenPipeline::TIME_STEPS(), times, 2);
  vtkNew<vtkTimeVaryingIntervalVolume> inTime;
  inTime->SetInputConnection(producer->GetOutputPort());
  inTime->SetInterval(0, -1.0, upper);
  warned.Texts.push_back(WarningsOf(inTime));
  warned.Reports.push_back(inTime->GetReport());
  return warned;
}

void ExpectFolded(vtkDataSet* data, vtkIdType folded, const std::string& part,
  const std::string& what, Check& check)
{
  const Warned warned = WarnAll(data, 0.4);
  for (std::size_t i = 0; i < warned.Texts.size(); ++i)
  {
    const std::string name = what + ", filter " + std::to_string(i);
    check.Equal(warned.Reports[i]->GetCount("FoldedCells"), folded, name);
    check.That(folded > 0 ? Contains(warned.Texts[i], part) : warned.Texts[i].empty(),
      name + ": " + warned.Texts[i]);
  }
}

/// Returns one cell with its points in the given order and the scalar x + y + z.
vtkSmartPointer<vtkUnstructuredGrid> MakeCell(
  int type, const std::vector<std::array<double, 3>>& corners, const std::vector<vtkIdType>& order)
{
  MeshBuilder builder;
  for (const auto& x : corners)
  {
    builder.AddPoint(x[0], x[1], x[2]);
  }
  builder.AddCell(type, order);
  auto grid = builder.GetMesh();
  AddLinearField(grid, { 0.0, { 1.0, 1.0, 1.0 } });
  return grid;
}

void CheckFolded(Check& check)
{
  const std::vector<std::array<double, 3>> cube = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 },
    { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } };
  const std::string part = "1 cells are folded or intersect themselves";
  const auto expect =
    [&](int type, const std::vector<vtkIdType>& order, bool isFolded, const std::string& what)
  { ExpectFolded(MakeCell(type, cube, order), isFolded ? 1 : 0, part, what, check); };
  expect(VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 6, 7 }, false, "a hexahedron");
  expect(VTK_HEXAHEDRON, { 4, 5, 6, 7, 0, 1, 2, 3 }, false, "a left-handed hexahedron");
  expect(VTK_HEXAHEDRON, { 0, 1, 3, 2, 4, 5, 7, 6 }, true, "a hexahedron numbered as a voxel");
  expect(VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 7, 6 }, true, "a hexahedron with a twisted face");
  expect(VTK_VOXEL, { 0, 1, 3, 2, 4, 5, 7, 6 }, false, "a voxel");
  expect(VTK_VOXEL, { 0, 1, 2, 3, 4, 5, 6, 7 }, true, "a voxel numbered as a hexahedron");
  expect(VTK_WEDGE, { 0, 1, 3, 4, 5, 7 }, false, "a wedge");
  expect(VTK_WEDGE, { 0, 1, 3, 5, 4, 7 }, true, "a wedge with a twisted face");
  expect(VTK_PYRAMID, { 0, 1, 2, 3, 4 }, false, "a pyramid");
  expect(VTK_PYRAMID, { 0, 1, 3, 2, 4 }, true, "a pyramid with a twisted base");
  expect(VTK_HEXAHEDRON, { 0, 1, 2, 2, 4, 5, 6, 6 }, false, "a hexahedron with collapsed edges");
  auto points = cube;
  points[6] = { { 0.7, 0.7, 0.7 } };
  ExpectFolded(MakeCell(VTK_HEXAHEDRON, points, { 0, 1, 2, 3, 4, 5, 6, 7 }), 0, part,
    "a hexahedron with a corner pushed in slightly", check);
  points[6] = { { 0.4, 0.4, 0.4 } };
  ExpectFolded(MakeCell(VTK_HEXAHEDRON, points, { 0, 1, 2, 3, 4, 5, 6, 7 }), 1, part,
    "a hexahedron with a corner pushed through", check);
  // The hexahedron with a twisted face as a structured grid, whose points are in voxel order.
  vtkNew<vtkStructuredGrid> structured;
  structured->SetDimensions(2, 2, 2);
  vtkNew<vtkPoints> twisted;
  for (const int corner : { 0, 1, 3, 2, 4, 5, 6, 7 })
  {
    twisted->InsertNextPoint(cube[corner].data());
  }
  structured->SetPoints(twisted);
  AddLinearField(structured, { 0.0, { 1.0, 1.0, 1.0 } });
  ExpectFolded(structured, 1, part, "a structured grid with a twisted face", check);
}

void CheckAxes(Check& check)
{
  const auto make = [](const std::vector<double>& y)
  {
    auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
    const int n = static_cast<int>(y.size());
    grid->SetDimensions(4, n, 3);
    vtkNew<vtkDoubleArray> axes[3];
    for (int i = 0; i < 4; ++i)
    {
      axes[0]->InsertNextValue(i);
      axes[2]->InsertNextValue(2 * i);
    }
    axes[2]->SetNumberOfTuples(3);
    for (const double value : y)
    {
      axes[1]->InsertNextValue(value);
    }
    grid->SetXCoordinates(axes[0]);
    grid->SetYCoordinates(axes[1]);
    grid->SetZCoordinates(axes[2]);
    AddLinearField(grid, { 0.0, { 1.0, 0.0, 0.0 } });
    return grid;
  };
  // A layer of cells perpendicular to the y axis has 3 x 2 cells.
  ExpectFolded(make({ 0, 1, 3 }), 0, "", "ascending coordinates", check);
  ExpectFolded(make({ 3, 1, 0 }), 0, "", "descending coordinates", check);
  ExpectFolded(make({ 0, 2, 1, 3 }), 6,
    "y coordinates are not strictly monotonic at index 2 (1 after 2)", "coordinates that turn back",
    check);
  ExpectFolded(make({ 0, 2, 2, 1, 3 }), 12, "at index 2 (2 after 2)",
    "coordinates that repeat and turn back", check);
  ExpectFolded(
    make({ 3, 2, 2, 1 }), 6, "at index 2 (2 after 2)", "descending coordinates that repeat", check);
}

/// Returns two AMR levels: 4 cells per axis from 0 to 4, and 4 finer cells per axis from 1 to 3.
vtkSmartPointer<vtkOverlappingAMR> MakeLevels()
{
  auto levels = vtkSmartPointer<vtkOverlappingAMR>::New();
  const int blocks[] = { 1, 1 };
  levels->Initialize(2, blocks);
  const double origin[] = { 0.0, 0.0, 0.0 };
  levels->SetOrigin(origin);
  levels->SetGridDescription(VTK_XYZ_GRID);
  for (unsigned int level = 0; level < 2; ++level)
  {
    vtkNew<vtkUniformGrid> grid;
    const double spacing = level == 0 ? 1.0 : 0.5;
    const double spacings[] = { spacing, spacing, spacing };
    grid->SetOrigin(level, level, level);
    grid->SetSpacing(spacings);
    grid->SetDimensions(5, 5, 5);
    AddLinearField(grid, { 0.0, { 1.0, 0.0, 0.0 } });
    levels->SetSpacing(level, spacings);
    levels->SetAMRBox(level, 0,
      vtkAMRBox(grid->GetOrigin(), grid->GetDimensions(), spacings, origin, VTK_XYZ_GRID));
    levels->SetDataSet(level, 0, grid);
    levels->SetRefinementRatio(level, 2);
  }
  return levels;
}

/// The isosurface x = 1.25 cuts the 16 coarse cells between x = 1 and x = 2. The fine level covers
/// four of these cells. Eight more share a face with it, two on each of its four sides.
void CheckLevels(Check& check)
{
  const auto levels = MakeLevels();
  for (const bool isBlanked : { false, true })
  {
    if (isBlanked)
    {
      vtkAMRUtilities::BlankCells(levels);
    }
    const Warned warned = WarnAll(levels, 1.25);
    for (std::size_t i = 0; i < warned.Texts.size(); ++i)
    {
      const std::string name = (isBlanked ? "blanked, filter " : "filter ") + std::to_string(i);
      check.Equal(
        warned.Reports[i]->GetCount("CoveredCells"), isBlanked ? 0 : 4, name + ": covered cells");
      check.Equal(warned.Reports[i]->GetCount("LevelFaces"), 8, name + ": faces between levels");
      check.That(
        Contains(warned.Texts[i],
          "4 cells of AMR levels are covered by a finer level but not blanked") == !isBlanked &&
          Contains(warned.Texts[i], "meet at 8 faces"),
        name + ": " + warned.Texts[i]);
    }
  }
  const Warned away = WarnAll(levels, 0.25);
  for (const std::string& text : away.Texts)
  {
    check.That(text.empty(), "no warning away from level boundaries: " + text);
  }
}
}

int TestIntervalVolumeWarnings(int, char*[])
{
  Check check;
  check.SetContext("concave polyhedra");
  CheckConcave(check);
  check.SetContext("far from the origin");
  CheckFar(check);
  check.SetContext("folded cells");
  CheckFolded(check);
  check.SetContext("rectilinear grids");
  CheckAxes(check);
  check.SetContext("AMR");
  CheckLevels(check);
  return check.Result();
}
