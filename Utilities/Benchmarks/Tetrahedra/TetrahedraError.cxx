// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Suites/BenchParts.h"

#include "Benchmarks/Measures/BenchTiming.h"
#include "Benchmarks/Tetrahedra/FieldImage.h"
#include "Benchmarks/Tetrahedra/TetrahedraMethods.h"
#include "Benchmarks/Tetrahedra/TetrahedraScene.h"

#include "vtkProjectedTetrahedraMapper.h"

#include <string>

namespace tetrahedra
{
namespace
{
const char* const Norm = "channel difference, mean";
const char* const Average = ", average color";

/// A mapper and the name of its method in rows.
struct Method
{
  std::string Name;
  vtkSmartPointer<vtkUnstructuredGridVolumeMapper> Mapper;
};

/// Returns all methods, the baseline first.
std::vector<Method> MakeMethods(vtkUnstructuredGrid* grid)
{
  std::vector<Method> methods;
  methods.push_back({ Baseline, vtkSmartPointer<vtkProjectedTetrahedraMapper>::New() });
  methods[0].Mapper->SetInputData(static_cast<vtkDataSet*>(grid));
  for (const RenderPath& path : AllRenderPaths())
  {
    RenderMode mode = GetDefaultMode();
    methods.push_back({ path.Name, NewMapper(grid, path, mode) });
    mode.Integration = vtkTimeWeightedTetrahedraMapper::AVERAGE_COLOR;
    methods.push_back({ std::string(path.Name) + Average, NewMapper(grid, path, mode) });
  }
  return methods;
}

void AddResolutionRows(SharedStage& stage, int cubes, const reference::RgbaImage& expected,
  const BenchOptions& options, BenchRows& rows)
{
  auto grid = MakeGrid(cubes);
  const std::vector<Method> methods = MakeMethods(grid);
  std::vector<BenchWork> works;
  works.reserve(methods.size());
  for (const Method& method : methods)
  {
    works.push_back(WithThreads(options.Threads, stage.MakeRenderWork(method.Mapper)));
  }
  const std::vector<BenchSeconds> seconds = MeasureAlternately(works, options.GetRepeats());
  // CaptureSeparately() requires mappers that have not rendered before.
  const std::vector<Method> fresh = MakeMethods(grid);
  for (std::size_t i = 0; i < methods.size(); ++i)
  {
    const reference::ImageError error =
      reference::CompareImages(stage.CaptureSeparately(fresh[i].Mapper), expected);
    BenchRow row = rows.Make("gyroid", methods[i].Name, cubes);
    row.SetError(Norm, error.Mean);
    row.Set({ { "tetrahedra", grid->GetNumberOfCells() }, { "largest_error", error.Max } });
    row.Seconds = seconds[i];
    if (i > 0)
    {
      row.Baseline = Baseline;
      row.BaselineSeconds = seconds[0];
    }
    rows.Add(row);
  }
}

/**
 * Measures errors of images of meshes at several resolutions, rendered by every render path and by
 * the baseline. The reference is an image of the field rendered without a mesh. The parameter is
 * the number of cubes along an edge of the mesh.
 */
void AddErrorRows(const BenchOptions& options, BenchRows& rows)
{
  const std::vector<int> resolutions =
    options.Pick<std::vector<int>>({ 8, 16, 32, 48 }, { 4, 8, 16 }, { 2, 4 });
  SharedStage stage(options.Pick(256, 128, 32));
  const reference::RgbaImage expected = RenderField(GetField, GetLow(), GetHigh(), MakeProperty(),
    MakeCamera(), stage.GetSize(), options.Pick(4000, 1000, 200));
  for (int cubes : resolutions)
  {
    AddResolutionRows(stage, cubes, expected, options, rows);
  }
}

std::vector<BenchPlot> MakeErrorPlots(const std::vector<BenchRow>& rows)
{
  BenchPlot plot = BenchPlot::OfErrors("tetrahedra-error",
    "a gyroid: error against run time as the mesh gets finer", "time of a frame (s)",
    std::string("error: ") + Norm,
    "Which render path and which integration mode are best as meshes get finer?",
    "A gyroid in cubes of five tetrahedra; labels are cubes along an edge. The reference is "
    "rendered from the formula. Ringed: the software path on the finest mesh, which is the default "
    "if OpenGL is software.");
  for (const BenchRow& row : rows)
  {
    plot.AddRow(row, row.Method == Baseline);
  }
  plot.SetDefault("software");
  return { plot };
}
}

BenchPart MakeErrorPart()
{
  return { AddErrorRows, MakeErrorPlots };
}
}
