// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Approximations/PictureFamilies.h"
#include "Benchmarks/Tetrahedra/TetrahedraMethods.h"
#include "Benchmarks/Tetrahedra/TetrahedraScene.h"
#include "Support/Pictures/ReferenceVolumePicture.h"

#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkProjectedTetrahedraMapper.h"

#include <cmath>
#include <utility>

namespace approximations
{
namespace
{
using Mapper = vtkTimeWeightedTetrahedraMapper;
using Mode = std::pair<const char*, tetrahedra::RenderMode>;

/// Cubes that are some ten times as wide at one side as at the other, of which centroids alone do
/// not tell the order.
vtkSmartPointer<vtkUnstructuredGrid> MakeGradedGrid(int cubes)
{
  auto grid = tetrahedra::MakeGrid(cubes);
  const double low = tetrahedra::GetLow();
  const double edge = tetrahedra::GetHigh() - low;
  for (vtkIdType id = 0; id < grid->GetNumberOfPoints(); ++id)
  {
    double x[3];
    grid->GetPoint(id, x);
    for (int axis = 0; axis < 3; ++axis)
    {
      x[axis] = low + edge * std::pow((x[axis] - low) / edge, axis == 0 ? 2.5 : 1.5);
    }
    grid->GetPoints()->SetPoint(id, x);
  }
  return grid;
}

/// Adds the modes on both paths; the first mode is the default, on the path that is.
void AddModes(tetrahedra::Theatre& theatre, vtkUnstructuredGrid* grid,
  const std::vector<Mode>& modes, const reference::RgbaPicture& expected,
  const BenchOptions& options, Trials& trials)
{
  auto usual =
    tetrahedra::NewMapper(grid, { "automatic", Mapper::AUTOMATIC_PATH }, modes.front().second);
  theatre.Capture(usual);
  for (const tetrahedra::RenderPath& path : tetrahedra::AllRenderPaths())
  {
    for (const Mode& mode : modes)
    {
      const bool isDefault = &mode == &modes.front() && path.Path == usual->GetReport().RenderPath;
      auto mapper = tetrahedra::NewMapper(grid, path, mode.second);
      trials.Add(path.Name, mode.first, isDefault ? Maker::Default : Maker::Own,
        WithThreads(options.Threads, [&theatre, mapper]() { return theatre.FrameOf(mapper)(); }),
        [&theatre, &expected, mapper]()
        { return reference::ComparePictures(theatre.Capture(mapper), expected).Mean; });
    }
  }
}

void AddPeer(tetrahedra::Theatre& theatre, vtkUnstructuredGrid* grid,
  const reference::RgbaPicture& expected, const BenchOptions& options, Trials& trials)
{
  auto mapper = vtkSmartPointer<vtkProjectedTetrahedraMapper>::New();
  mapper->SetInputData(static_cast<vtkDataSet*>(grid));
  trials.Add(tetrahedra::Peer, "centroid", Maker::Peer,
    WithThreads(options.Threads, [&theatre, mapper]() { return theatre.FrameOf(mapper)(); }),
    [&theatre, &expected, grid]()
    {
      vtkNew<vtkProjectedTetrahedraMapper> fresh;
      fresh->SetInputData(static_cast<vtkDataSet*>(grid));
      return reference::ComparePictures(theatre.CaptureApart(fresh), expected).Mean;
    });
}

reference::RgbaPicture MakeExpected(vtkUnstructuredGrid* grid, int pixels)
{
  reference::PictureSettings settings;
  settings.Size = { { pixels, pixels } };
  return reference::MakeReferencePicture(
    grid, tetrahedra::MakeProperty(), tetrahedra::MakeCamera(), settings);
}

/// A gyroid on graded or even cubes, drawn in each of the modes.
void AddRowsOf(const Question& question, vtkUnstructuredGrid* grid, int cubes,
  const std::vector<Mode>& modes, const BenchOptions& options, BenchRows& rows)
{
  const int pixels = options.Pick(256, 128, 32);
  tetrahedra::Theatre theatre(pixels);
  const reference::RgbaPicture expected = MakeExpected(grid, pixels);
  Trials trials;
  trials.SetSize("cubes along an edge", cubes);
  trials.SetSize("pixels along an edge", pixels);
  AddModes(theatre, grid, modes, expected, options, trials);
  AddPeer(theatre, grid, expected, options, trials);
  trials.Run(question, options, rows);
}

int PickCubes(const BenchOptions& options)
{
  return options.Pick(24, 12, 3);
}

void AddSortRows(const Question& question, const BenchOptions& options, BenchRows& rows)
{
  const int blend = Mapper::COMPOSITE_BLEND;
  const int integral = Mapper::LINEAR_SEGMENT;
  AddRowsOf(question, MakeGradedGrid(PickCubes(options)), PickCubes(options),
    { { "automatic (MPVONC)", { "", blend, Mapper::AUTOMATIC_SORT, integral, true } },
      { "centroid", { "", blend, Mapper::CENTROID_SORT, integral, true } },
      { "none", { "", blend, Mapper::NO_SORT, integral, true } } },
    options, rows);
}

void AddBlendRows(const Question& question, const BenchOptions& options, BenchRows& rows)
{
  const int sort = Mapper::AUTOMATIC_SORT;
  const int integral = Mapper::LINEAR_SEGMENT;
  AddRowsOf(question, tetrahedra::MakeGrid(PickCubes(options)), PickCubes(options),
    { { "automatic (composite)", { "", Mapper::AUTOMATIC_BLEND, sort, integral, true } },
      { "optical depth", { "", Mapper::OPTICAL_DEPTH_BLEND, sort, integral, true } },
      { "priority", { "", Mapper::PRIORITY_BLEND, sort, integral, true } },
      { "additive", { "", Mapper::ADDITIVE_BLEND, sort, integral, true } },
      { "maximum", { "", Mapper::MAXIMUM_INTENSITY_BLEND, sort, integral, true } } },
    options, rows);
}
}

Family MakeSortFamily()
{
  return { { "sort-mode", "Order of tetrahedra: error against time of a frame",
             "Which order of tetrahedra is worth its time?",
             "A gyroid in graded cubes of five tetrahedra, composited front to back; against the "
             "same mesh integrated along each line of sight in its order of visibility.",
             "time of a frame (s)", "channel difference, mean" },
    AddSortRows };
}

Family MakeBlendFamily()
{
  return {
    { "blend-mode", "Blend modes: error against time of a frame",
      "How far from the picture in order of visibility are the blend modes without order?",
      "A gyroid in cubes of five tetrahedra, in two colours, four layers by their place; against "
      "the same mesh integrated along each line of sight in its order of visibility.",
      "time of a frame (s)", "channel difference, mean" },
    AddBlendRows
  };
}
}
