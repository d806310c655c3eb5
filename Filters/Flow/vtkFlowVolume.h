// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkFlowVolume_h
#define vtkFlowVolume_h

#include "InterlumeFlowModule.h"   // for the export macro
#include "vtkFlowVolumeSettings.h" // for the settings
#include "vtkInterlumeReport.h"    // for GetReport()
#include "vtkIntervalList.h"       // for the intervals
#include "vtkNew.h"                // for the report
#include "vtkUnstructuredGridAlgorithm.h"

#include <memory>
#include <string>
#include <vector>

class vtkDataSet;

namespace interlume
{
class Error;
class ImplicitFlowArrays;
class SurfaceLevels;
class VolumeExtraction;
struct FlowVolumeReport;
}

/**
 * @class   vtkFlowVolume
 * @brief   extract stream volumes, clipped by advection time, with stream and time surfaces
 *
 * Extracts the region { x : lower <= Inflow(x) <= upper, start <= AdvectionTime(x) <= end } of an
 * implicit flow field as tetrahedra, with the case tables of vtkIntervalVolume. The filter computes
 * no streamlines. It extracts by Inflow first, then by time; a changed time range repeats only the
 * second extraction. Documentation/methods/flow-volumes.md explains how cells are cut at
 * termination surfaces and behind obstacles, and the errors and limits.
 *
 * Input: vtkImageData, vtkRectilinearGrid, vtkStructuredGrid or vtkUnstructuredGrid with the arrays
 * of vtkFlowStatus (TerminationSide is optional), and with Inflow from vtkInflowMapping if there
 * are intervals or stream surfaces. Without intervals, all values of Inflow are extracted.
 *
 * Skipped cells, most of which the report counts:
 * - Cells with corners of different FlowStatus or TerminationId, and cells on a seam where the
 *   mapping is discontinuous. A cell is on a seam if the parameters of its corners differ by more
 *   than half a period. On seams where the mapping is continuous (InflowPeriodic; all seams if
 *   there is no Inflow), parameters are unwrapped on duplicated points and exceed 1. Polyhedra on
 *   seams are skipped.
 * - Cells in which time jumps on a termination surface. If the input has far-side samples, such
 *   cells, and cells whose corners differ only because a surface crosses them, are cut at the
 *   surface, and each side is extracted separately.
 * - Cells that contain the boundary edge of a surface, two surfaces, or a separatrix. Use
 *   vtkImplicitFlowField::SetRefinementLevels for these.
 * - Lower-dimensional, hidden and ghost cells, and cells where a required Inflow is NaN.
 *
 * Output port 0: tetrahedra with the input's arrays except TerminationSide, and the cell arrays
 * `IntervalId` (int: interval of Inflow; 0 if there are none) and `TimeIntervalId` (int: the
 * TimeSurfaceId at the lower end of the cell's times). Stream and time surfaces consist of faces of
 * tetrahedra, so no tetrahedron crosses a surface.
 *
 * Output port 1: triangles of stream surfaces, at the interval bounds and at StreamSurfaces. Cell
 * arrays: `StreamSurfaceId` (int: index of the surface's value in the ascending list of all values)
 * and `Inflow` (double: the value). Output port 2: triangles of time surfaces, at start, end and
 * TimeSurfaces. Cell array: `TimeSurfaceId` (int: index of the surface's time in the ascending list
 * of all times, including times outside the range). Ports 1 and 2 share the points of port 0. Each
 * triangle occurs once and faces against the gradient of Inflow or AdvectionTime. With
 * GenerateNormals, point normals `Normals` (float) point against that gradient too.
 *
 * All ports have the input's field arrays. The active scalars are Inflow, or AdvectionTime if there
 * is no Inflow. The output is identical for any number of threads. Cells cut at a surface next to a
 * piece boundary may differ slightly from those of the whole dataset. The filter retains its
 * extractions between executions.
 *
 * Warnings (vtkWarningMacro, not if one of several pieces is requested): an interval or the time
 * range outside the range of the input; an empty volume, with the reasons; GenerateStreamSurfaces
 * without any value or interval.
 *
 * Errors (vtkErrorMacro, empty outputs): missing arrays, or wrong numbers of components; lower >
 * upper, start > end or non-finite bounds; more than 10000 intervals between surfaces; invalid
 * global ids.
 *
 * @sa vtkImplicitFlowField vtkInflowMapping vtkStreamSurfaceParameters
 */
class INTERLUMEFLOW_EXPORT vtkFlowVolume
  : public vtkUnstructuredGridAlgorithm
  , private vtkFlowVolumeSettings
{
public:
  static vtkFlowVolume* New();
  vtkTypeMacro(vtkFlowVolume, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Intervals of Inflow: lower <= upper, both finite. Default: none, which selects all cells with a
   * result. Valid number: 0 to 10000; clamped.
   */
  void SetNumberOfIntervals(int number);
  int GetNumberOfIntervals() const { return this->Intervals.GetNumber(); }
  void SetInterval(int i, double lower, double upper);
  void GetInterval(int i, double& lower, double& upper) const;
  ///@}

  ///@{
  /**
   * Time range to which the volume is clipped, in units of AdvectionTime. A start of 0 or less does
   * not clip. Without TimeSurfaces, an end at or above the largest time of the input does not clip
   * either. Default: 0 to VTK_DOUBLE_MAX.
   */
  vtkSetVector2Macro(TimeRange, double);
  vtkGetVector2Macro(TimeRange, double);
  ///@}

  ///@{
  /**
   * Maximum difference of AdvectionTime between the corners of a cell. Cells that exceed it are
   * skipped. Use it for surfaces that the samples do not resolve. Default: 0 (no limit). Valid: 0
   * and above; clamped.
   */
  vtkSetClampMacro(MaximumTimeJump, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumTimeJump, double);
  ///@}

  ///@{
  /**
   * Inflow values and advection times of additional surfaces inside the volume. Values outside the
   * volume produce no surface. Values not yet set are 0. Default: none. Valid numbers: 0 to 10000;
   * clamped. SetStreamSurface and SetTimeSurface add surfaces as needed. The Get functions return 0
   * for an invalid index.
   */
  void SetNumberOfStreamSurfaces(int number);
  int GetNumberOfStreamSurfaces() const { return static_cast<int>(this->StreamSurfaces.size()); }
  void SetStreamSurface(int i, double value);
  double GetStreamSurface(int i) const;
  void SetNumberOfTimeSurfaces(int number);
  int GetNumberOfTimeSurfaces() const { return static_cast<int>(this->TimeSurfaces.size()); }
  void SetTimeSurface(int i, double time);
  double GetTimeSurface(int i) const;
  ///@}

  ///@{
  /**
   * Create the stream surfaces (port 1), the time surfaces (port 2), and point normals on both.
   * Default: off, off, off.
   */
  vtkSetMacro(GenerateStreamSurfaces, bool);
  vtkGetMacro(GenerateStreamSurfaces, bool);
  vtkBooleanMacro(GenerateStreamSurfaces, bool);
  vtkSetMacro(GenerateTimeSurfaces, bool);
  vtkGetMacro(GenerateTimeSurfaces, bool);
  vtkBooleanMacro(GenerateTimeSurfaces, bool);
  vtkSetMacro(GenerateNormals, bool);
  vtkGetMacro(GenerateNormals, bool);
  vtkBooleanMacro(GenerateNormals, bool);
  ///@}

  ///@{
  /**
   * If true, TerminationUV becomes the active texture coordinates of the outputs. A texture then
   * appears as if painted on the termination surface and advected by the flow. Default: off.
   */
  vtkSetMacro(ParametersAsTextureCoordinates, bool);
  vtkGetMacro(ParametersAsTextureCoordinates, bool);
  vtkBooleanMacro(ParametersAsTextureCoordinates, bool);
  ///@}

  ///@{
  /**
   * Precision of the output points, as in vtkIntervalVolume. Default: DEFAULT_PRECISION (the
   * precision of the input's points; float for image data). Valid: SINGLE_PRECISION to
   * DEFAULT_PRECISION; clamped.
   */
  vtkSetClampMacro(OutputPointsPrecision, int, SINGLE_PRECISION, DEFAULT_PRECISION);
  vtkGetMacro(OutputPointsPrecision, int);
  ///@}

  /**
   * Return the report of the last execution:
   * - Cells: cells of the input,
   * - CellsWithoutResult: cells with a corner whose streamline reached no surface,
   * - CellsBetweenSurfaces: cells whose corners' streamlines reached different surfaces,
   * - CellsOnSeams: cells on a seam where the mapping is discontinuous,
   * - CellsAcrossSurfaces: cells in which time is discontinuous because they are crossed by the
   *   surface that their streamlines reach,
   * - CellsWithTimeJumps: other cells in which time changes by more than MaximumTimeJump,
   * - CellsCut: cells counted as CellsWithoutResult, CellsBetweenSurfaces or CellsAcrossSurfaces
   *   that were cut at a surface instead of skipped,
   * - CellsAroundPoles: cells whose parameters cannot be unwrapped to within half a period.
   */
  vtkInterlumeReport* GetReport() { return this->Report; }

  /**
   * Return a sentence about the last execution: the number of cells that were skipped, with the
   * reasons, and that were cut at a surface. Empty before the first execution. The text is valid
   * until the next call.
   */
  const char* GetSummary();

protected:
  vtkFlowVolume();
  ~vtkFlowVolume() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkFlowVolume(const vtkFlowVolume&) = delete;
  void operator=(const vtkFlowVolume&) = delete;

  /// Returns an error if the arrays or the settings cannot be used.
  interlume::Error CheckParameters(vtkDataSet* input, bool usesInflow) const;
  void SetNumberOfSurfaces(std::vector<double>& values, int number);
  void SetSurface(std::vector<double>& values, int i, double value);
  /// Returns a warning that names the missing part of the volume and the range of the input, or an
  /// empty string if nothing is missing.
  std::string DescribeMissing(vtkDataSet* input, const interlume::ImplicitFlowArrays& arrays,
    vtkUnstructuredGrid* mesh, const interlume::FlowVolumeReport& report) const;
  /// Fills port 0 from the last extraction.
  void FillMesh(const interlume::SurfaceLevels& byInflow, const interlume::SurfaceLevels& byTime,
    vtkUnstructuredGrid* mesh) const;

  vtkIntervalList Intervals;
  std::vector<double> StreamSurfaces;
  std::vector<double> TimeSurfaces;
  vtkNew<vtkInterlumeReport> Report;
  std::string Summary;
  std::unique_ptr<interlume::VolumeExtraction> Extraction;
};

#endif
