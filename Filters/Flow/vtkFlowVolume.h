// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkFlowVolume_h
#define vtkFlowVolume_h

#include "InterlumeFlowModule.h"   // for the export macro
#include "vtkFlowVolumeSettings.h" // for what is set
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
 * @brief   stream volumes clipped by advection time, with their stream and time surfaces, in one
 * mesh
 *
 * Extracts the region { x : lower <= Inflow(x) <= upper, start <= AdvectionTime(x) <= end } of an
 * implicit flow field (C. Zhang, dissertation, Ohio State 2006, sections 4.5 and 4.5.4, equation
 * 4.1), by the tables of vtkIntervalVolume for Inflow and again for time. Nothing is advected:
 * other intervals cost both extractions, other times alone only the second one. A bound that cuts
 * nothing costs none, but for one extraction that makes tetrahedra of the cells where nothing cuts
 * at all.
 *
 * **Nothing is interpolated** between samples of different status or TerminationId, or across a
 * seam that the mapping does not continue over: such cells are left out and counted (GetReport).
 * Across a seam that it does continue over (InflowPeriodic; all seams where the input has no
 * Inflow) parameters are unwrapped, so that TerminationUV goes on above 1 there, on points of their
 * own; not in polyhedra, which are left out there. A cell is taken to lie across a seam where its
 * parameters differ by more than half a period.
 *
 * Time is not interpolated where it jumps on a termination surface that streamlines come back to,
 * as TerminationSide tells; where streamlines leave both sides for the surface, as where it is the
 * middle of a source, time is 0 from both sides and does not jump.
 *
 * **Cells are cut at the surface** where time jumps so, and where their corners have different
 * answers, or none, only because a termination surface passes through them: each side is extracted
 * by itself up to the surface, where time is 0 or what it is behind. Values go on to the surface as
 * the streamlines do that vtkImplicitFlowField has followed for that (vtkFlowStatus::BeyondPrefix);
 * where these leave the field or just miss the surface they stay those of a corner, off by up to
 * what they change in a cell. The surface is where the distance and its gradients at the corners
 * have it, to fourth order along an edge, and flat between edges: of a ball of radius 4.3 cells 1.1
 * % of the volume are missing, beside a plane nothing. Cells that hold the rim of a surface, or two
 * surfaces, or whose corners on one side differ too, as at separatrices, are left out;
 * RefinementLevels of vtkImplicitFlowField are for these. So are all such cells where Inflow is not
 * made by vtkInflowMapping.
 *
 * **Behind obstacles.** If the field has hidden cells or points, or vectors that are not finite,
 * cells only some of whose corners reach a surface are cut at the boundary of what reaches it,
 * which vtkImplicitFlowField has located on the edges of such cells. The boundary is flat between
 * edges. Cells whose corners reach two surfaces are left out. Inflow is linear along the edges of
 * these cells too: next to the boundary tubes narrower than two cells of samples have several
 * percent too little volume, which finer samples or RefinementLevels mend.
 *
 * Surfaces that lie between the corners of a cell without parting them, as a box thinner than a
 * cell, are not found; nor are the sheets of streamlines that just miss a surface's rim, behind
 * which others take another turn. MaximumTimeJump is for these.
 *
 * Input: vtkImageData, rectilinear, structured or unstructured grids with the arrays of
 * vtkFlowStatus (TerminationSide may be missing), and of vtkInflowMapping where there are intervals
 * or stream surfaces. Without intervals all of Inflow counts (a time volume needs no mapping).
 * Cells of fewer dimensions, cells that are hidden or ghosts, and cells with NaN in Inflow, where
 * it counts, are left out too.
 *
 * Output port 0: tetrahedra with the point arrays of the input but TerminationSide, its cell
 * arrays, and the cell arrays `IntervalId` (int), the interval of Inflow (0 without), and
 * `TimeIntervalId` (int), the TimeSurfaceId of the surface at the lower end of the cell's times.
 * Stream and time surfaces are faces of tetrahedra, so that no cell lies on both sides of one.
 * Other arrays are as vtkIntervalVolume leaves them.
 *
 * Output port 1: triangles of stream surfaces: the bounds of the intervals and StreamSurfaces. Cell
 * arrays `StreamSurfaceId` (int: the place of its value among all of these, ascending), `Inflow`
 * (double: the value). Output port 2: triangles of time surfaces: start, end and TimeSurfaces, cell
 * array `TimeSurfaceId` (int: the place of its time among all of these, ascending, those outside of
 * the range too). Both share the points of port 0, with their ids and arrays; a triangle is there
 * once, and faces against the gradient of what it is a level set of. Point normals `Normals`
 * (float) when GenerateNormals is on: against that gradient, from the tetrahedra; 0 at points of no
 * triangle. All ports have the field arrays of the input.
 *
 * Inflow, or AdvectionTime where there is none, is left as the active scalars of all ports.
 *
 * Warnings (vtkWarningMacro), but for pieces, of which others may have something: an interval or
 * the time range outside of what the input has, with that range; an empty volume, with what became
 * of the cells; stream surfaces without a value.
 *
 * The output is the same for any number of threads. In pieces, cells that are cut at a surface may
 * go on to it from other neighbours than in the whole: volumes differ by up to 0.24 % in the tests.
 * Between executions the filter holds on to the input's arrays and to the result of each
 * extraction.
 *
 * Errors (vtkErrorMacro, empty outputs): arrays that are missing or of the wrong shape, lower >
 * upper, start > end, bounds that are not finite, more than 10000 intervals between surfaces,
 * global ids that are not one integer for each point.
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
   * The intervals of Inflow: lower <= upper, both finite. Default none, which takes every cell that
   * has an answer. Valid number: 0 to 10000.
   */
  void SetNumberOfIntervals(int number);
  int GetNumberOfIntervals() const { return this->Intervals.GetNumber(); }
  void SetInterval(int i, double lower, double upper);
  void GetInterval(int i, double& lower, double& upper) const;
  ///@}

  ///@{
  /**
   * The times that the volume is clipped to. Default 0 to VTK_DOUBLE_MAX, which clips nothing; nor
   * does a start below 0, or without TimeSurfaces an end from the largest time of the input on.
   */
  vtkSetVector2Macro(TimeRange, double);
  vtkGetVector2Macro(TimeRange, double);
  ///@}

  ///@{
  /**
   * The most that AdvectionTime may differ between the corners of a cell; other cells are left out.
   * Default 0: no limit. Valid: 0 and above.
   */
  vtkSetClampMacro(MaximumTimeJump, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumTimeJump, double);
  ///@}

  ///@{
  /**
   * Values of Inflow and advection times of further surfaces inside the volume; values outside of
   * it give no surface. New values are 0. Default none. Valid numbers: 0 to 10000. SetStreamSurface
   * and SetTimeSurface add surfaces where there are fewer; the Get functions give 0 where there is
   * none.
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
   * Whether port 1 carries its triangles, whether port 2 does, and whether they have normals.
   * Default off, off, off.
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
   * Whether TerminationUV is the active texture coordinates of the outputs, which shows a texture
   * laid on the termination surface and carried by the flow. Default off.
   */
  vtkSetMacro(ParametersAsTextureCoordinates, bool);
  vtkGetMacro(ParametersAsTextureCoordinates, bool);
  vtkBooleanMacro(ParametersAsTextureCoordinates, bool);
  ///@}

  ///@{
  /**
   * The precision of the output points, as in vtkIntervalVolume. Default DEFAULT_PRECISION: that of
   * the input's points; float for image data.
   */
  vtkSetClampMacro(OutputPointsPrecision, int, SINGLE_PRECISION, DEFAULT_PRECISION);
  vtkGetMacro(OutputPointsPrecision, int);
  ///@}

  /**
   * Returns what the last execution did:
   * - Cells: cells of the input,
   * - CellsWithoutResult: cells with a corner that reached no surface,
   * - CellsBetweenSurfaces: cells with corners of different surfaces,
   * - CellsOnSeams: cells on a seam that the mapping does not continue over,
   * - CellsAcrossSurfaces: cells across their own termination surface, where time jumps,
   * - CellsWithTimeJumps: other cells in which time jumps by more than MaximumTimeJump,
   * - CellsCut: cells without a result, between surfaces or across one that were cut there,
   * - CellsAroundPoles: cells whose parameters are wrong, since no unwrapping brings their corners
   *   within half a period.
   */
  vtkInterlumeReport* GetReport() { return this->Report; }

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
  /// Returns which part of the volume is missing, and what the input has; nothing where nothing is
  /// missing.
  std::string DescribeMissing(vtkDataSet* input, const interlume::ImplicitFlowArrays& arrays,
    vtkUnstructuredGrid* mesh, const interlume::FlowVolumeReport& report) const;
  /// Fills port 0 from the last extraction.
  void FillMesh(const interlume::SurfaceLevels& byInflow, const interlume::SurfaceLevels& byTime,
    vtkUnstructuredGrid* mesh) const;

  vtkIntervalList Intervals;
  std::vector<double> StreamSurfaces;
  std::vector<double> TimeSurfaces;
  vtkNew<vtkInterlumeReport> Report;
  std::unique_ptr<interlume::VolumeExtraction> Extraction;
};

#endif
