// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Suites/BenchParts.h"

#include "Benchmarks/Measures/BenchTiming.h"
#include "Benchmarks/Tetrahedra/FieldPicture.h"
#include "Benchmarks/Tetrahedra/TetrahedraMethods.h"
#include "Benchmarks/Tetrahedra/TetrahedraScene.h"

#include "vtkProjectedTetrahedraMapper.h"

#include <string>

namespace tetrahedra
{
namespace
{
const char* const Norm = "channel difference, mean";
const char* const Average = ", average colour";

/// A mapper and its name in the rows.
struct Method
{
  std::string Name;
  vtkSmartPointer<vtkUnstructuredGridVolumeMapper> Mapper;
};

/// The peer first.
std::vector<Method> MakeMethods(vtkUnstructuredGrid* grid)
{
  std::vector<Method> methods;
  methods.push_back({ Peer, vtkSmartPointer<vtkProjectedTetrahedraMapper>::New() });
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

void AddResolutionRows(Theatre& theatre, int cubes, const reference::RgbaPicture& expected,
  const BenchOptions& options, BenchRows& rows)
{
  auto grid = MakeGrid(cubes);
  const std::vector<Method> methods = MakeMethods(grid);
  std::vector<BenchWork> works;
  works.reserve(methods.size());
  for (const Method& method : methods)
  {
    works.push_back(WithThreads(options.Threads, theatre.FrameOf(method.Mapper)));
  }
  const std::vector<BenchSeconds> seconds = MeasureAlternately(works, options.GetRepeats());
  // Mappers that have not drawn before, each in its own window.
  const std::vector<Method> fresh = MakeMethods(grid);
  for (std::size_t i = 0; i < methods.size(); ++i)
  {
    const reference::PictureError error =
      reference::ComparePictures(theatre.CaptureApart(fresh[i].Mapper), expected);
    BenchRow row = rows.Make("gyroid", methods[i].Name, cubes);
    row.SetError(Norm, error.Mean);
    row.Set({ { "tetrahedra", grid->GetNumberOfCells() }, { "largest_error", error.Max } });
    row.Seconds = seconds[i];
    if (i > 0)
    {
      row.Peer = Peer;
      row.PeerSeconds = seconds[0];
    }
    rows.Add(row);
  }
}

/**
 * Pictures of meshes of several resolutions, by every render path and the peer, against the picture
 * of the field without a mesh. The parameter is the number of cubes along an edge.
 */
void AddErrorRows(const BenchOptions& options, BenchRows& rows)
{
  const std::vector<int> resolutions =
    options.Pick<std::vector<int>>({ 8, 16, 32, 48 }, { 4, 8, 16 }, { 2, 4 });
  Theatre theatre(options.Pick(256, 128, 32));
  const reference::RgbaPicture expected = IntegrateField(GetField, GetLow(), GetHigh(),
    MakeProperty(), MakeCamera(), theatre.GetSize(), options.Pick(4000, 1000, 200));
  for (int cubes : resolutions)
  {
    AddResolutionRows(theatre, cubes, expected, options, rows);
  }
}

std::vector<BenchPlot> MakeErrorPlots(const std::vector<BenchRow>& rows)
{
  BenchPlot plot = BenchPlot::OfErrors("tetrahedra-error",
    "a gyroid: error against run time as the mesh gets finer", "time of a frame (s)",
    std::string("error: ") + Norm,
    "Which path and which integration of a tetrahedron, as meshes get finer?",
    "A gyroid in cubes of five tetrahedra, cubes along an edge at each point, against the "
    "formula's own picture. Ringed: the software path, which is the default where OpenGL is "
    "software, on the finest mesh.");
  for (const BenchRow& row : rows)
  {
    plot.AddRow(row, row.Method == Peer);
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
