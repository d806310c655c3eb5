// SPDX-License-Identifier: BSD-3-Clause
// Flow around a blunt fin: extraction by one attribute and coloring by another.

#include "Gallery/Look.h"
#include "Gallery/Props.h"
#include "Gallery/Scene.h"
#include "Gallery/Stage.h"
#include "Gallery/Volumes.h"
#include "Support/Inputs/DataFiles.h"

#include "vtkActor.h"
#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkImageData.h"
#include "vtkImageGaussianSmooth.h"
#include "vtkIntervalVolume.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkStructuredData.h"
#include "vtkStructuredGrid.h"

#include <cstdlib>
#include <utility>
#include <vector>

namespace
{
using namespace gallery;

/// Returns the top of the fin: a surface between the upper edges of its two sides.
vtkSmartPointer<vtkPolyData> MakeLid(vtkStructuredGrid* flow)
{
  int dimensions[3];
  flow->GetDimensions(dimensions);
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> quads;
  for (int i = 0; i <= dimensions[0] / 2; ++i)
  {
    for (const int side : { i, dimensions[0] - 1 - i })
    {
      int index[3] = { side, 0, dimensions[2] - 1 };
      points->InsertNextPoint(flow->GetPoint(vtkStructuredData::ComputePointId(dimensions, index)));
    }
    if (i > 0)
    {
      const vtkIdType last = 2 * static_cast<vtkIdType>(i);
      const vtkIdType corners[4] = { last - 2, last - 1, last + 1, last };
      quads->InsertNextCell(4, corners);
    }
  }
  vtkNew<vtkPolyData> lid;
  lid->SetPoints(points);
  lid->SetPolys(quads);
  return MakeSurface(lid);
}

/// Smooths \a values of a grid, mainly along i, since the shock has steps of one cell there.
vtkSmartPointer<vtkDataArray> Smooth(vtkDataArray* values, const int dimensions[3])
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(dimensions);
  image->GetPointData()->SetScalars(values);
  vtkNew<vtkImageGaussianSmooth> smooth;
  smooth->SetInputData(image);
  smooth->SetStandardDeviations(2.0, 0.5, 0.0);
  smooth->SetRadiusFactor(3.0);
  smooth->Update();
  vtkSmartPointer<vtkDataArray> result = smooth->GetOutput()->GetPointData()->GetScalars();
  result->SetName(values->GetName());
  return result;
}

/// Reads one half of the flow past a blunt fin and adds its mirror image. The surface i = 0 of the
/// grid is the plane of symmetry, y = 0, upstream of the fin. Both halves share the points of that
/// surface. Only point arrays with one component are retained.
vtkSmartPointer<vtkStructuredGrid> ReadBluntFin()
{
  vtkSmartPointer<vtkDataSet> data = interlume::ReadData("bluntfin.vts");
  vtkStructuredGrid* half = vtkStructuredGrid::SafeDownCast(data);
  int dimensions[3];
  half->GetDimensions(dimensions);
  int fullDimensions[3] = { 2 * dimensions[0] - 1, dimensions[1], dimensions[2] };
  auto full = vtkSmartPointer<vtkStructuredGrid>::New();
  full->SetDimensions(fullDimensions);
  vtkNew<vtkPoints> points;
  points->SetDataType(half->GetPoints()->GetDataType());
  points->SetNumberOfPoints(
    static_cast<vtkIdType>(fullDimensions[0]) * fullDimensions[1] * fullDimensions[2]);
  full->SetPoints(points);
  std::vector<std::pair<vtkDataArray*, vtkSmartPointer<vtkDataArray>>> arrays;
  for (int array = 0; array < half->GetPointData()->GetNumberOfArrays(); ++array)
  {
    vtkDataArray* from = half->GetPointData()->GetArray(array);
    if (from && from->GetNumberOfComponents() == 1)
    {
      auto to = vtkSmartPointer<vtkDataArray>::Take(from->NewInstance());
      to->SetName(from->GetName());
      to->SetNumberOfTuples(points->GetNumberOfPoints());
      arrays.emplace_back(from, to);
    }
  }
  for (int k = 0; k < dimensions[2]; ++k)
  {
    for (int j = 0; j < dimensions[1]; ++j)
    {
      for (int i = 0; i < fullDimensions[0]; ++i)
      {
        const int offset = i - (dimensions[0] - 1);
        int index[3] = { std::abs(offset), j, k };
        int fullIndex[3] = { i, j, k };
        const vtkIdType from = vtkStructuredData::ComputePointId(dimensions, index);
        const vtkIdType to = vtkStructuredData::ComputePointId(fullDimensions, fullIndex);
        double point[3];
        half->GetPoint(from, point);
        points->SetPoint(to, point[0], offset < 0 ? -point[1] : point[1], point[2]);
        for (const auto& array : arrays)
        {
          array.second->SetTuple(to, from, array.first);
        }
      }
    }
  }
  for (const auto& array : arrays)
  {
    full->GetPointData()->AddArray(Smooth(array.second, fullDimensions));
  }
  return full;
}

/// Returns the fin: both sides (surface j = 0) and the top.
vtkSmartPointer<vtkActor> MakeBluntFin(vtkStructuredGrid* flow, const vtkColor3d& color)
{
  vtkNew<vtkAppendPolyData> fin;
  fin->AddInputData(MakeGridSurface(flow, 1, 0));
  fin->AddInputData(MakeLid(flow));
  fin->Update();
  return MakeActor(fin->GetOutput(), color);
}

/// Returns the plate on which the fin stands (surface k = 0).
vtkSmartPointer<vtkActor> MakeBluntFinPlate(vtkStructuredGrid* flow, const vtkColor3d& color)
{
  return MakeActor(MakeGridSurface(flow, 2, 0), color);
}

void BuildIntervalLinear(gallery::Stage& stage)
{
  const double lower = 1.2;
  const double upper = 4.0;
  vtkSmartPointer<vtkStructuredGrid> flow = ReadBluntFin();
  vtkNew<vtkIntervalVolume> interval;
  interval->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Density");
  interval->SetInterval(0, lower, 5.0);
  vtkSmartPointer<vtkUnstructuredGrid> tetrahedra = stage.Extract(interval, flow);

  vtkSmartPointer<vtkColorTransferFunction> colors =
    gallery::MakeColorMap(gallery::Map::Viridis, lower, upper);
  vtkNew<vtkPiecewiseFunction> extinction;
  // Transparent at the lower bound, since the grid is too coarse for a smooth boundary far from the
  // fin.
  extinction->AddPoint(lower, 0.0);
  extinction->AddPoint(1.5, 0.3);
  extinction->AddPoint(2.0, 1.2);
  extinction->AddPoint(upper, 8.0);
  gallery::Panel& panel = stage.AddPanel("", { -1.0, 0.55, 0.5 });
  panel.Frame(vtkBoundingBox(-1.5, 10.0, -4.0, 4.0, 0.0, 7.0));
  panel.SetBackground({ 0.86, 0.90, 0.95 });
  panel.SetAmbientOcclusion(0.0);
  panel.Add(MakeBluntFinPlate(flow, { 0.80, 0.79, 0.77 }));
  panel.Add(MakeBluntFin(flow, { 0.80, 0.79, 0.77 }));
  panel.Add(gallery::MakeVolume(tetrahedra, "Density", colors, extinction));
  stage.SetColorBar("density (free stream 1)", colors, lower, upper);
}

const gallery::SceneRegistration intervalLinear({ "interval-linear", "3.3",
  "One interval of a curvilinear grid, colored by value",
  "A supersonic stream meets a blunt fin that stands on a plate. The cloud is the air denser than "
  "1.2 times the free stream, between the shock and the fin. Color and opacity are functions of "
  "density, so that the dense air at the edge of the fin is visible through the thinner air around "
  "it. The data contain one half of the flow, smoothed here; the other half is its mirror image.",
  { "bluntfin.vts" }, &BuildIntervalLinear });

void BuildIntervalTwoAttributes(gallery::Stage& stage)
{
  const double lower = 8.0;
  const double upper = 24.0;
  vtkSmartPointer<vtkStructuredGrid> flow = ReadBluntFin();
  vtkNew<vtkIntervalVolume> interval;
  interval->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Density");
  interval->SetInterval(0, 1.2, 5.0);
  vtkSmartPointer<vtkUnstructuredGrid> tetrahedra = stage.Extract(interval, flow);

  // The map starts below the lower bound, since its dark colors are not visible on the background.
  vtkSmartPointer<vtkColorTransferFunction> colors =
    gallery::MakeColorMap(gallery::Map::Inferno, 2.0, upper);
  vtkNew<vtkPiecewiseFunction> extinction;
  // Faint at low energy, since the grid is too coarse for a smooth volume far from the fin.
  extinction->AddPoint(lower, 0.0);
  extinction->AddPoint(11.0, 0.3);
  extinction->AddPoint(14.0, 1.4);
  extinction->AddPoint(18.0, 2.4);
  extinction->AddPoint(upper, 5.0);
  gallery::Panel& panel = stage.AddPanel("", { -1.0, -0.5, 0.55 });
  panel.Frame(vtkBoundingBox(-1.0, 7.0, -2.5, 2.5, 0.0, 5.7));
  panel.SetBackground({ 0.16, 0.18, 0.22 });
  panel.SetAmbientOcclusion(0.0);
  panel.Add(MakeBluntFinPlate(flow, { 0.40, 0.42, 0.46 }));
  panel.Add(MakeBluntFin(flow, { 0.60, 0.62, 0.66 }));
  panel.Add(gallery::MakeVolume(tetrahedra, "StagnationEnergy", colors, extinction));
  stage.SetColorBar(
    "stagnation energy where the density is above 1.2 (free stream 1)", colors, lower, upper);
}

const gallery::SceneRegistration intervalTwoAttributes(
  { "interval-two-attributes", "3.9", "Extracted by density, colored by energy",
    "A supersonic stream meets a blunt fin that stands on a plate. The volume is the dense air "
    "between the shock and the fin. Its color and opacity are functions of another attribute, the "
    "stagnation energy, which the extraction interpolates: it is highest along the leading edge. "
    "The data contain one half of the flow, smoothed here; the other half is its mirror image.",
    { "bluntfin.vts" }, &BuildIntervalTwoAttributes });
}
