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
 * What one scene did and what it used. Counts are measured, not declared: a feature that is off
 * leaves its counts at 0 and its name out of Features.
 */
struct SceneReport
{
  std::string Id;
  std::string Figure;
  /// Pixels of the picture.
  int Width = 0;
  int Height = 0;

  /// Wall clock: reading and building, of that the extraction filters, and drawing.
  double BuildSeconds = 0.0;
  double ExtractSeconds = 0.0;
  double RenderSeconds = 0.0;
  /// The frames of its animation, how long they took to draw and write, and whether a movie was
  /// made of them.
  int Frames = 0;
  double FrameSeconds = 0.0;
  bool HasMovie = false;

  /// Names of what was on: `criteria`, `boundaries`, `time`, `time-boundaries` (those of
  /// tetrahedra), `time-slices`, `flow`, `stream-surfaces`, `time-surfaces`, `volumes`, `slices`,
  /// `inflow-textures`, `shadows`, `ambient-occlusion`.
  std::set<std::string> Features;

  /// Extraction filters run, their intervals and criteria, and what came out.
  int Filters = 0;
  int Intervals = 0;
  int Criteria = 0;
  vtkIdType Tetrahedra = 0;
  vtkIdType BoundaryTriangles = 0;
  /// Of interval volumes in space and time: the most slabs between steps, and the 4-simplices.
  int Slabs = 0;
  vtkIdType Simplices = 0;
  /// Values of the filters' reports by their names: the sum, or the largest of those that do not
  /// add up.
  std::map<std::string, vtkIdType> Extraction{ { "Cells", 0 }, { "CellsVisited", 0 },
    { "CellsWithOutput", 0 }, { "LowerDimensionalCells", 0 }, { "NonFiniteCells", 0 },
    { "BlankedCells", 0 }, { "LinearizedCells", 0 }, { "UnsupportedCells", 0 },
    { "CollapsedSimplices", 0 }, { "ArraysInterpolated", 0 }, { "ArraysCopied", 0 },
    { "Passes", 0 }, { "WorkingBytes", 0 } };

  /// Of flow volumes: cells of the implicit flow fields, those left out because nothing may be
  /// interpolated in them, and extractions by inflow and by advection time.
  vtkIdType FlowCells = 0;
  vtkIdType FlowCellsLeftOut = 0;
  int InflowPasses = 0;
  int TimePasses = 0;

  /// Panels, those that have surfaces, and of these those with ambient occlusion.
  int Panels = 0;
  int SurfacePanels = 0;
  int OcclusionPanels = 0;
  /// Passes over the surfaces of a panel, over the tetrahedra of each volume and over the buffers
  /// of each volume of slices, summed over panels; the screen-space passes of ambient occlusion are
  /// among them.
  int Passes = 0;
  /// Off-screen textures of the drawing, and the bytes they take, the window's own included.
  int Buffers = 0;
  vtkIdType Bytes = 0;
  /// Copies of the reports of the volumes: of tetrahedra, of slices, and of inflow textures. Their
  /// passes, buffers and bytes are in the sums above.
  using VolumeReports = std::vector<vtkSmartPointer<vtkInterlumeReport>>;
  VolumeReports Volumes;
  VolumeReports SlicedVolumes;
  VolumeReports InflowVolumes;

  /// Adds the report of an extraction filter.
  void AddExtraction(vtkInterlumeReport* filter);
  ///@{
  /// Add the report of a volume's mapper.
  void AddVolume(vtkInterlumeReport* volume);
  void AddSlicedVolume(vtkInterlumeReport* volume);
  void AddInflowVolume(vtkInterlumeReport* volume);
  ///@}
};

nlohmann::json ToJson(const SceneReport& report);

/// Returns the sum of all entries of values of a report.
double SumValues(vtkInterlumeReport* report, std::initializer_list<const char*> names);
}

#endif
