// SPDX-License-Identifier: BSD-3-Clause
#ifndef SceneReport_h
#define SceneReport_h

#include "vtkInterlumeReport.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <initializer_list>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace gallery
{
/**
 * Costs and statistics of one scene. If a feature is inactive, its counts are 0 and its name is not
 * in Features.
 */
struct SceneReport
{
  std::string Id;
  std::string Figure;
  /// Size of the image in pixels.
  int Width = 0;
  int Height = 0;

  /// Wall-clock times: of building the scene (including reading files), of the extraction filters
  /// (part of the build time), and of rendering.
  double BuildSeconds = 0.0;
  double ExtractSeconds = 0.0;
  double RenderSeconds = 0.0;
  /// Number of animation frames, the time to render and write them, and whether a movie was
  /// written.
  int Frames = 0;
  double FrameSeconds = 0.0;
  bool HasMovie = false;

  /// Names of the active features: `criteria`, `boundaries`, `time`, `time-boundaries` (boundaries
  /// that consist of tetrahedra), `time-slices`, `flow`, `stream-surfaces`, `time-surfaces`,
  /// `volumes`, `slices`, `inflow-textures`, `shadows`, `scene-shadows`, `ambient-occlusion`.
  std::set<std::string> Features;

  /// Numbers of executed extraction filters, of their intervals and criteria, and of the cells in
  /// their outputs.
  int Filters = 0;
  int Intervals = 0;
  int Criteria = 0;
  vtkIdType Tetrahedra = 0;
  vtkIdType BoundaryTriangles = 0;
  /// Time-varying interval volumes: the maximum number of time slabs over all filters, and the
  /// number of 4-simplices.
  int Slabs = 0;
  vtkIdType Simplices = 0;
  /// Values of the filters' reports by name: the sum over the filters, or the maximum for values
  /// that cannot be added.
  std::map<std::string, vtkIdType> Extraction{ { "Cells", 0 }, { "CellsVisited", 0 },
    { "CellsWithOutput", 0 }, { "LowerDimensionalCells", 0 }, { "NonFiniteCells", 0 },
    { "BlankedCells", 0 }, { "LinearizedCells", 0 }, { "UnsupportedCells", 0 },
    { "CollapsedSimplices", 0 }, { "ArraysInterpolated", 0 }, { "ArraysCopied", 0 },
    { "Passes", 0 }, { "WorkingBytes", 0 } };

  /// Flow volumes: the numbers of cells of the implicit flow fields, of cells that were skipped
  /// because values cannot be interpolated in them, and of extraction passes by inflow value and by
  /// advection time.
  vtkIdType FlowCells = 0;
  vtkIdType SkippedFlowCells = 0;
  int InflowPasses = 0;
  int TimePasses = 0;

  /// Number of panels, of panels with surfaces, and of panels with ambient occlusion.
  int Panels = 0;
  int SurfacePanels = 0;
  int OcclusionPanels = 0;
  /// Number of passes in all panels: passes over surfaces, passes of volume mappers, and
  /// screen-space passes of ambient occlusion.
  int Passes = 0;
  /// Number of off-screen textures used for rendering, including window buffers, and their size in
  /// bytes.
  int Buffers = 0;
  vtkIdType Bytes = 0;
  /// Copies of the mappers' reports for volumes of tetrahedra, sliced volumes, and volumes with
  /// inflow textures. The members Passes, Buffers and Bytes include the values of these reports.
  using VolumeReports = std::vector<vtkSmartPointer<vtkInterlumeReport>>;
  VolumeReports Volumes;
  VolumeReports SlicedVolumes;
  VolumeReports InflowVolumes;

  /// Adds the report of an extraction filter.
  void AddExtraction(vtkInterlumeReport* filter);
  ///@{
  /// Add the report of a volume mapper.
  void AddVolume(vtkInterlumeReport* volume);
  void AddSlicedVolume(vtkInterlumeReport* volume);
  void AddInflowVolume(vtkInterlumeReport* volume);
  ///@}
};

nlohmann::json ToJson(const SceneReport& report);

/// Returns the sum of the named values of a report, over all entries of each value.
double SumValues(vtkInterlumeReport* report, std::initializer_list<const char*> names);
}

#endif
