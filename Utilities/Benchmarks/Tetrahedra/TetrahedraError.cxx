// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Tetrahedra/TetrahedraParts.h"

#include "Benchmarks/Measures/BenchTiming.h"
#include "Benchmarks/Tetrahedra/FieldPicture.h"
#include "Benchmarks/Tetrahedra/TetrahedraMethods.h"
#include "Benchmarks/Tetrahedra/TetrahedraScene.h"

#include "vtkNew.h"
#include "vtkProjectedTetrahedraMapper.h"
#include "vtkRenderWindow.h"
#include "vtkUnstructuredGridLinearRayIntegrator.h"
#include "vtkUnstructuredGridVolumeRayCastMapper.h"
#include "vtkUnstructuredGridVolumeZSweepMapper.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace tetrahedra
{
namespace
{
const char* const Norm = "channel difference, mean";
const char* const RayCast = "raycast";
const char* const ZSweep = "zsweep";
const char* const Average = ", average colour";

/// A mapper and its name in the rows.
struct Method
{
  std::string Name;
  vtkSmartPointer<vtkUnstructuredGridVolumeMapper> Mapper;
};

bool IsPeer(const std::string& method)
{
  return method == Peer || method == RayCast || method == ZSweep;
}

/// VTK's mappers that make rays, with a ray for each pixel.
template <typename Mapper>
Method MakeRayMethod(const char* name)
{
  auto mapper = vtkSmartPointer<Mapper>::New();
  mapper->SetRayIntegrator(vtkNew<vtkUnstructuredGridLinearRayIntegrator>());
  mapper->AutoAdjustSampleDistancesOff();
  mapper->SetImageSampleDistance(1.0);
  return { name, mapper };
}

/// The peer first.
std::vector<Method> MakeMethods(vtkUnstructuredGrid* grid)
{
  std::vector<Method> methods;
  methods.push_back({ Peer, vtkSmartPointer<vtkProjectedTetrahedraMapper>::New() });
  methods.push_back(MakeRayMethod<vtkUnstructuredGridVolumeRayCastMapper>(RayCast));
  methods.push_back(MakeRayMethod<vtkUnstructuredGridVolumeZSweepMapper>(ZSweep));
  for (const Method& method : methods)
  {
    method.Mapper->SetInputData(static_cast<vtkDataSet*>(grid));
  }
  for (const RenderPath& path : AllRenderPaths())
  {
    RenderMode mode = GetDefaultMode();
    methods.push_back({ path.Name, NewMapper(grid, path, mode) });
    mode.Integration = vtkTimeWeightedTetrahedraMapper::AVERAGE_COLOR;
    methods.push_back({ std::string(path.Name) + Average, NewMapper(grid, path, mode) });
  }
  return methods;
}

reference::RgbaPicture MakeExpected(const Theatre& theatre, int steps)
{
  return IntegrateField(
    GetField, GetLow(), GetHigh(), MakeProperty(), MakeCamera(), theatre.GetSize(), steps);
}

/// The smallest error of three mappers: VTK's ray mappers stretch a picture now and then.
std::vector<reference::PictureError> MeasureErrors(
  const Theatre& theatre, vtkUnstructuredGrid* grid, const reference::RgbaPicture& expected)
{
  std::vector<reference::PictureError> errors;
  for (int attempt = 0; attempt < 3; ++attempt)
  {
    const std::vector<Method> methods = MakeMethods(grid);
    for (std::size_t i = 0; i < methods.size(); ++i)
    {
      const bool isRay = methods[i].Name == RayCast || methods[i].Name == ZSweep;
      if (attempt > 0 && !isRay)
      {
        continue;
      }
      const reference::PictureError error =
        reference::ComparePictures(theatre.CaptureApart(methods[i].Mapper), expected);
      if (attempt == 0)
      {
        errors.push_back(error);
      }
      else if (error.Mean < errors[i].Mean)
      {
        errors[i] = error;
      }
    }
  }
  return errors;
}

BenchRow MakeRow(const BenchRows& rows, const std::string& method, vtkUnstructuredGrid* grid,
  const reference::PictureError& error)
{
  BenchRow row = rows.Make("gyroid", method);
  row.SetError(Norm, error.Mean);
  row.Set({ { "tetrahedra", grid->GetNumberOfCells() }, { "largest_error", error.Max } });
  return row;
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
  const std::vector<reference::PictureError> errors = MeasureErrors(theatre, grid, expected);
  for (std::size_t i = 0; i < methods.size(); ++i)
  {
    BenchRow row = MakeRow(rows, methods[i].Name, grid, errors[i]);
    row.Parameter = cubes;
    row.Seconds = seconds[i];
    if (!IsPeer(methods[i].Name))
    {
      row.Peer = Peer;
      row.PeerSeconds = seconds[0];
    }
    rows.Add(row);
  }
}

std::string StrideText(int pixels, int tetrahedra)
{
  return "stride of pixels " + std::to_string(pixels) + ", of tetrahedra " +
    std::to_string(tetrahedra);
}

/// What a path draws when ever less time is allowed for a frame.
void AddStrideRows(Theatre& theatre, const RenderPath& path, int cubes,
  const reference::RgbaPicture& expected, const BenchOptions& options, BenchRows& rows)
{
  auto grid = MakeGrid(cubes);
  auto mapper = NewMapper(grid, path, GetDefaultMode());
  mapper->AutoAdjustLevelOfDetailOn();
  const BenchWork frame = WithThreads(options.Threads, theatre.FrameOf(mapper));
  frame();
  const BenchSeconds full = TimeOnce(frame);
  std::set<std::pair<int, int>> seen;
  for (double share : { 1.0, 0.5, 0.2, 0.08, 0.03 })
  {
    // The mapper learns from its last frames what fits.
    theatre.GetStage().GetWindow()->SetDesiredUpdateRate(share < 1.0 ? 1.0 / (share * full) : 1e-4);
    for (int warm = 0; warm < 3; ++warm)
    {
      frame();
    }
    const BenchSeconds seconds = MeasureAlternately({ frame }, options.GetRepeats())[0];
    const auto error = reference::ComparePictures(theatre.Capture(mapper), expected);
    const vtkTetrahedraReport& report = mapper->GetReport();
    if (seen.emplace(report.PixelStride, report.TetrahedronStride).second)
    {
      BenchRow row = MakeRow(rows, std::string(path.Name) + ", level of detail", grid, error);
      row.Parameter = StrideText(report.PixelStride, report.TetrahedronStride);
      row.Seconds = seconds;
      rows.Add(row);
    }
  }
  theatre.GetStage().GetWindow()->SetDesiredUpdateRate(1e-4);
}

/**
 * Pictures of meshes of several resolutions, by every render path and VTK's three mappers, against
 * the picture of the field without a mesh. The parameter is the number of cubes along an edge. Then
 * the coarser pictures of the level of detail: the parameter is the pixel stride.
 */
void AddErrorRows(const BenchOptions& options, BenchRows& rows)
{
  const std::vector<int> resolutions =
    options.Pick<std::vector<int>>({ 8, 16, 32, 48 }, { 4, 8, 16 }, { 2, 4 });
  Theatre theatre(options.Pick(256, 128, 32));
  const reference::RgbaPicture expected = MakeExpected(theatre, options.Pick(4000, 1000, 200));
  for (int cubes : resolutions)
  {
    AddResolutionRows(theatre, cubes, expected, options, rows);
  }
  for (const RenderPath& path : AllRenderPaths())
  {
    AddStrideRows(theatre, path, resolutions.back(), expected, options, rows);
  }
}

std::vector<BenchPlot> MakeErrorPlots(const std::vector<BenchRow>& rows)
{
  const std::string time = "time of a frame (s)";
  const std::string error = std::string("error: ") + Norm;
  BenchPlot finer = BenchPlot::OfErrors("tetrahedra-error",
    "a gyroid: error against run time as the mesh gets finer", time, error,
    "Which path and which integration of a tetrahedron, as meshes get finer?",
    "A gyroid in cubes of five tetrahedra, cubes along an edge at each point, against the "
    "formula's own picture. Ringed: the software path, which is the default where OpenGL is "
    "software, on the finest mesh.");
  BenchPlot coarser = BenchPlot::OfErrors("tetrahedra-level-of-detail",
    "a gyroid: error against run time as the level of detail falls", time, error,
    "What does the level of detail of tetrahedra cost in error?",
    "The finest of these meshes, with less and less time allotted to a frame.");
  for (const BenchRow& row : rows)
  {
    (row.Parameter.is_string() ? coarser : finer).AddRow(row, IsPeer(row.Method));
  }
  finer.SetDefault("software");
  coarser.SetDefault("software, level of detail", StrideText(1, 1));
  return { finer, coarser };
}
}

BenchPart MakeErrorPart()
{
  return { AddErrorRows, MakeErrorPlots };
}
}
