// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkFlowLIC_h
#define vtkFlowLIC_h

#include "InterlumeFlowModule.h" // for the export macro
#include "vtkDataSetAlgorithm.h"
#include "vtkInterlumeReport.h" // for GetReport()
#include "vtkNew.h"             // for the report

#include <memory>

namespace interlume
{
class Error;
class MeshLinks;
struct FillValues;
struct FlowLICReport;
}

/**
 * @class   vtkFlowLIC
 * @brief   compute line integral convolution at the points of any dataset
 *
 * Computes for each point the weighted mean of a noise function along the streamline through it,
 * over Length in both directions (line integral convolution). If the points are those of an image,
 * the result is a LIC volume. If they are those of a surface, it is a LIC texture that does not
 * depend on surface parameters; the surface's triangles must be smaller than NoiseScale, see
 * RefineSurface.
 * Documentation/methods/flow-volumes.md has the equations.
 *
 * The noise consists of uniform random values on a regular grid in space with spacing NoiseScale,
 * interpolated smoothly. The noise at a position is the same in any dataset. The output is scaled
 * to standard deviation Contrast around 1/2 and clamped to [0, 1]. For streamlines that end early,
 * the scaling accounts for the shorter kernel, so contrast is uniform.
 *
 * Input port 0: any dataset, at whose points the LIC is computed. Optional input port 1: the field,
 * as vtkImageData, vtkRectilinearGrid, vtkStructuredGrid or vtkUnstructuredGrid with
 * three-dimensional cells. Without an input on port 1, the input of port 0 is the field. The
 * vectors are an array of the field: SetInputArrayToProcess(0, ...), by default the active vectors.
 * Cell vectors are averaged at the points, as in vtkImplicitFlowField.
 *
 * Output: the input of port 0 with the point array `LIC` (float, 0 to 1) as active scalars. `LIC`
 * is 0 at points outside the field. Where the velocity is 0 or not finite, it is the scaled noise.
 *
 * Streamlines use the classical fourth-order Runge-Kutta method with StepLength. They end where
 * they would leave the field, where the velocity vanishes, or where it turns by more than a right
 * angle in one step. The output is identical for any number of threads.
 *
 * Warnings (vtkWarningMacro, not if one of several pieces is requested): all points are outside the
 * field; vectors that look like fill values (see vtkImplicitFlowField::SetMaximumError), or are NaN
 * or infinite.
 *
 * Errors (vtkErrorMacro, empty output): missing vectors, or vectors without three components; an
 * unsupported field, or one without three-dimensional cells; more than 1,000,000 steps for Length.
 *
 * @sa vtkStreamlineTexture vtkImplicitFlowField
 */
class INTERLUMEFLOW_EXPORT vtkFlowLIC : public vtkDataSetAlgorithm
{
public:
  static vtkFlowLIC* New();
  vtkTypeMacro(vtkFlowLIC, vtkDataSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Set the field, on port 1.
  void SetFieldConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }
  void SetFieldData(vtkDataSet* field);

  enum Kernels
  {
    /// Constant kernel, k(s) = 1.
    BOX = 0,
    /// Hann window, k(s) = (1 + cos(pi s / Length)) / 2.
    HANN = 1
  };

  ///@{
  /**
   * Kernel that weights the noise along a streamline. Default: HANN. Valid: see Kernels; clamped.
   */
  vtkSetClampMacro(Kernel, int, BOX, HANN);
  vtkGetMacro(Kernel, int);
  ///@}

  ///@{
  /**
   * Length of streamlines in each direction, in world units. 0 selects ten times NoiseScale.
   * Default: 0. Valid: 0 and above; clamped.
   */
  vtkSetClampMacro(Length, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Length, double);
  ///@}

  ///@{
  /**
   * Spacing of the noise grid, in world units. 0 selects 1/128 of the diagonal of the bounds of
   * port 0. If that is too fine, 0 selects twice the mean spacing of the points or, with
   * RefineSurface, twice the longest edge. Default: 0. Valid: 0 and above; clamped.
   */
  vtkSetClampMacro(NoiseScale, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(NoiseScale, double);
  ///@}

  ///@{
  /**
   * Step length along a streamline, in world units. It is reduced so that Length is a multiple of
   * it. 0 selects a quarter of NoiseScale. Default: 0. Valid: 0 and above; clamped.
   */
  vtkSetClampMacro(StepLength, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(StepLength, double);
  ///@}

  ///@{
  /**
   * If true, and the input of port 0 is a vtkPolyData with polygons or strips, these become
   * triangles with edges of at most half of NoiseScale, and the output is the refined surface
   * without vertices and lines. Point arrays are interpolated, cell arrays copied. Edges are longer
   * if this would add more than about 40,000 triangles. Default: off.
   */
  vtkSetMacro(RefineSurface, bool);
  vtkGetMacro(RefineSurface, bool);
  vtkBooleanMacro(RefineSurface, bool);
  ///@}

  ///@{
  /**
   * If true, and the input of port 0 is a vtkPolyData with polygons, streamlines follow the
   * component of the vectors in the tangent plane of the surface at their start. Otherwise, flow
   * through the surface has no streaks on it. Default: off.
   */
  vtkSetMacro(ProjectVectors, bool);
  vtkGetMacro(ProjectVectors, bool);
  vtkBooleanMacro(ProjectVectors, bool);
  ///@}

  ///@{
  /**
   * Seed of the noise. Default: 0.
   */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

  ///@{
  /**
   * Standard deviation of the output before clamping. A value of 0.2 clamps 1.2 % of a normal
   * distribution. Default: 0.2. Valid: 0 to 1; clamped.
   */
  vtkSetClampMacro(Contrast, double, 0.0, 1.0);
  vtkGetMacro(Contrast, double);
  ///@}

  /**
   * Return the report of the last execution:
   * - Points: points of the output,
   * - PointsOutside: points outside the field, whose value is 0,
   * - PointsAtRest: points in the field whose velocity is not finite, or whose speed is at most
   *   1e-9 of the field's largest speed,
   * - PointsWithShortLines: other points in the field whose streamline ends before Length,
   * - Steps: steps in each direction of a complete streamline,
   * - StepLength, Length, NoiseScale: lengths in use, with automatic values resolved,
   * - FillValues: points of the field with vectors that look like fill values,
   * - NonFiniteVectors: points of the field's cells with vectors that are NaN or infinite,
   * - ConvertedCellArrays: name of the vectors if they are a cell array.
   */
  vtkInterlumeReport* GetReport() { return this->Report; }

protected:
  vtkFlowLIC();
  ~vtkFlowLIC() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkFlowLIC(const vtkFlowLIC&) = delete;
  void operator=(const vtkFlowLIC&) = delete;

  /// Determines the length and the number of steps, and stores them in the report. Returns an error
  /// if there are too many steps.
  interlume::Error FindSteps(interlume::FlowLICReport& report) const;
  /// Copies the points to the output, or refines the surface. Determines the noise scale.
  void PreparePoints(
    vtkDataSet* points, vtkDataSet* output, interlume::FlowLICReport& report) const;
  /// Returns true if RefineSurface is on and \a points is a surface.
  bool CanRefine(vtkDataSet* points) const;
  ///@{
  /// Add the array of values to the output. ConvolveField creates the field's walker for Convolve.
  interlume::Error ConvolveField(vtkDataSet* field, vtkDataArray* vectors, vtkDataSet* output,
    interlume::FlowLICReport& report, interlume::FillValues& fill);
  template <typename Walker>
  void Convolve(
    const Walker& walker, vtkDataSet* points, float* values, interlume::FlowLICReport& report);
  ///@}
  /// Warns about special vectors, and if all points are outside the field. \a vectors is the name
  /// of the vectors.
  void Warn(vtkDataSet* field, const char* vectors, const interlume::FillValues& fill,
    const interlume::FlowLICReport& report);

  int Kernel = HANN;
  double Length = 0.0;
  double NoiseScale = 0.0;
  double StepLength = 0.0;
  bool RefineSurface = false;
  bool ProjectVectors = false;
  int Seed = 0;
  double Contrast = 0.2;
  vtkNew<vtkInterlumeReport> Report;
  /// Mesh topology of the last field, cached for the next execution.
  std::shared_ptr<const interlume::MeshLinks> Mesh;
};

#endif
