// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Data/BenchData.h"

#include "Support/Inputs/DataFiles.h"

#include "vtkAppendFilter.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkRTAnalyticSource.h"

#include <algorithm>
#include <array>
#include <random>
#include <stdexcept>

namespace
{
/// A file in Data/ with the point array and the interval to extract.
struct RealSet
{
  const char* Case;
  const char* File;
  const char* Array;
  double Lower;
  double Upper;
  bool InQuick;
};

const RealSet RealSets[] = {
  { "head-ct", "headsq_quarter.vti", "density", 1000.0, 2000.0, false },
  { "isabel", "isabel_pressure_sub100.vti", "pressure", -1500.0, -500.0, false },
  { "blunt-fin", "bluntfin.vts", "Density", 0.8, 2.0, true },
  { "disk-out", "disk_out_ref.vtu", "Temp", 400.0, 600.0, true },
};

BenchData ReadRealSet(const RealSet& set)
{
  BenchData data;
  data.Case = set.Case;
  data.Data = CopyWithOneArray(interlume::ReadData(set.File), set.Array);
  data.Lower = set.Lower;
  data.Upper = set.Upper;
  return data;
}

/// A cell type with its corners in VTK order.
struct CellShape
{
  int Type;
  const char* Name;
  std::vector<std::array<double, 3>> Corners;
};

const CellShape& ShapeOf(int cellType)
{
  static const CellShape Shapes[] = {
    { VTK_TETRA, "tetrahedra", { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } } },
    { VTK_PYRAMID, "pyramids",
      { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0.5, 0.5, 1 } } },
    { VTK_WEDGE, "wedges",
      { { 0, 0, 0 }, { 0, 1, 0 }, { 1, 0, 0 }, { 0, 0, 1 }, { 0, 1, 1 }, { 1, 0, 1 } } },
    { VTK_HEXAHEDRON, "hexahedra",
      { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 1 }, { 1, 1, 1 },
        { 0, 1, 1 } } },
  };
  for (const CellShape& shape : Shapes)
  {
    if (shape.Type == cellType)
    {
      return shape;
    }
  }
  throw std::runtime_error(
    "Random cells of VTK cell type " + std::to_string(cellType) + " are not supported");
}
}

vtkSmartPointer<vtkDataSet> CopyWithOneArray(vtkDataSet* from, const std::string& name)
{
  vtkDataArray* array = from->GetPointData()->GetArray(name.c_str());
  if (!array)
  {
    throw std::runtime_error("The dataset has no point array \"" + name + "\"");
  }
  auto data = vtk::TakeSmartPointer(from->NewInstance());
  data->CopyStructure(from);
  data->GetPointData()->SetScalars(array);
  return data;
}

vtkSmartPointer<vtkRTAnalyticSource> MakeWaveletSource(int points)
{
  // The source scales its field to its extent, so the waves are the same at every resolution.
  auto source = vtkSmartPointer<vtkRTAnalyticSource>::New();
  const int half = points / 2;
  source->SetWholeExtent(
    -half, points - 1 - half, -half, points - 1 - half, -half, points - 1 - half);
  return source;
}

BenchData MakeWavelet(int points)
{
  const auto source = MakeWaveletSource(points);
  source->Update();
  BenchData data;
  data.Case = "wavelet-" + std::to_string(points);
  data.Data = source->GetOutput();
  data.Lower = WaveletLower;
  data.Upper = WaveletUpper;
  return data;
}

int GetWaveletResolution(const BenchOptions& options)
{
  return options.Pick(97, 41, 13);
}

std::vector<BenchData> MakeSpeedCases(const BenchOptions& options)
{
  std::vector<BenchData> cases;
  cases.push_back(MakeWavelet(GetWaveletResolution(options)));
  for (const RealSet& set : RealSets)
  {
    if (options.Size == BenchOptions::TINY || (options.Size == BenchOptions::QUICK && !set.InQuick))
    {
      continue;
    }
    cases.push_back(ReadRealSet(set));
  }
  return cases;
}

BenchData MakeSpeedCase(const std::string& name, const BenchOptions& options)
{
  const BenchData wavelet = MakeWavelet(GetWaveletResolution(options));
  if (name == wavelet.Case)
  {
    return wavelet;
  }
  for (const RealSet& set : RealSets)
  {
    if (name == set.Case)
    {
      return ReadRealSet(set);
    }
  }
  throw std::runtime_error("The suites interval and contour have no case " + name);
}

vtkSmartPointer<vtkUnstructuredGrid> ToHexahedra(vtkDataSet* data)
{
  vtkNew<vtkAppendFilter> append;
  append->SetInputData(data);
  append->Update();
  vtkUnstructuredGrid* from = append->GetOutput();
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(from->GetPoints());
  grid->GetPointData()->ShallowCopy(from->GetPointData());
  grid->AllocateExact(from->GetNumberOfCells(), 8 * from->GetNumberOfCells());
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < from->GetNumberOfCells(); ++cell)
  {
    int type = from->GetCellType(cell);
    from->GetCellPoints(cell, ids);
    if (type == VTK_VOXEL)
    {
      // Voxels order their points along x first; hexahedra order them around the bottom, then
      // around the top.
      std::swap(*ids->GetPointer(2), *ids->GetPointer(3));
      std::swap(*ids->GetPointer(6), *ids->GetPointer(7));
      type = VTK_HEXAHEDRON;
    }
    grid->InsertNextCell(type, ids);
  }
  return grid;
}

BenchData MakeRandomCells(int cellType, int numberOfCells, unsigned int seed)
{
  const CellShape& shape = ShapeOf(cellType);
  const std::size_t corners = shape.Corners.size();
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> values;
  values->SetName("value");
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->AllocateEstimate(numberOfCells, static_cast<vtkIdType>(corners));
  std::vector<vtkIdType> ids(corners);
  for (int cell = 0; cell < numberOfCells; ++cell)
  {
    for (std::size_t i = 0; i < corners; ++i)
    {
      // All cells are at the origin. Rounding errors of large coordinates could look like
      // inversions.
      ids[i] = points->InsertNextPoint(shape.Corners[i].data());
      values->InsertNextValue(uniform(generator));
    }
    grid->InsertNextCell(cellType, static_cast<vtkIdType>(corners), ids.data());
  }
  grid->SetPoints(points);
  grid->GetPointData()->SetScalars(values);
  BenchData data;
  data.Case = std::string("random-") + shape.Name;
  data.Data = grid;
  data.Lower = 0.3;
  data.Upper = 0.7;
  return data;
}
