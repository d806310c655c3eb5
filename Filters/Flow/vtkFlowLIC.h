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
struct FlowLICReport;
}

/**
 * @class   vtkFlowLIC
 * @brief   line integral convolution at the points of any dataset
 *
 * Computes for each point the mean of a noise along its streamline, over Length both ways (B.
 * Cabral and L. Leedom, Imaging Vector Fields Using Line Integral Convolution, SIGGRAPH 1993):
 *
 *   m(x) = integral of k(s) n(c(s)) ds / integral of k(s) ds, s from -Length to Length,
 *
 * c the streamline through x by arc length (dc/ds = v/|v|, c(0) = x), n a noise in space, k the
 * kernel. Where the streamline ends before Length, both integrals end there. An image gives a
 * volume of LIC; the points of a surface give one on it that does not depend on parameters of the
 * surface, as in C. Zhang, dissertation, Ohio State 2006, figure 4.6. A surface needs triangles
 * that are smaller than NoiseScale.
 *
 * The noise is one of values at the points of a lattice, NoiseScale apart, uniform in 0 ... 1 by a
 * hash of the indices and Seed, smoothly interpolated. It belongs to space: points that different
 * datasets share have the same result.
 *
 * Means vary less than the noise does, the less the longer the kernel is. The output is stretched
 * by what the kernel makes of the noise's variance on straight lines: 1/2 + Contrast (m - 1/2) /
 * sigma, held to 0 ... 1. sigma is computed for the part of the kernel that counts for the point,
 * so that contrast does not change where streamlines end.
 *
 * Input port 0: any dataset, whose points count. Port 1, optional: the field, vtkImageData,
 * rectilinear, structured or unstructured grids with cells of three dimensions; without it port 0
 * is the field. The vectors are the array to process 0 of the field (point data; default the active
 * vectors).
 *
 * Output: the input of port 0 with the point array `LIC` (float, 0 to 1), the active scalars. It is
 * 0 where the point is outside of the field, which is counted; where the velocity is 0 or not
 * finite, it is the noise itself, stretched alike.
 *
 * Streamlines are followed by the classical Runge-Kutta method of fourth order with StepLength.
 * They end where a step would leave the field, and where the velocity vanishes or turns by more
 * than a right angle in a step. The output is the same for any number of threads.
 *
 * Warnings (vtkWarningMacro), but not for pieces: all points are outside of the field; vectors that
 * look like fill values (as for vtkImplicitFlowField::SetMaximumError), with the value; vectors
 * that are NaN or infinite.
 *
 * Errors (vtkErrorMacro, empty output): no vectors, or not three components at points; a field that
 * is no such dataset or that has no cells of three dimensions; more than 1,000,000 steps for
 * Length.
 *
 * @sa vtkStreamlineTexture vtkImplicitFlowField
 */
class INTERLUMEFLOW_EXPORT vtkFlowLIC : public vtkDataSetAlgorithm
{
public:
  static vtkFlowLIC* New();
  vtkTypeMacro(vtkFlowLIC, vtkDataSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Sets the field, on port 1.
  void SetFieldConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }
  void SetFieldData(vtkDataSet* field);

  enum Kernels
  {
    /// The constant kernel, k(s) = 1.
    BOX = 0,
    /// The Hann window, k(s) = (1 + cos(pi s / Length)) / 2.
    HANN = 1
  };

  ///@{
  /**
   * The kernel that the noise is weighted with. Default HANN. Valid: see Kernels; clamped.
   */
  vtkSetClampMacro(Kernel, int, BOX, HANN);
  vtkGetMacro(Kernel, int);
  ///@}

  ///@{
  /**
   * How far streamlines are followed each way, in units of length. Default 0: ten times NoiseScale.
   * Valid: 0 and above; clamped.
   */
  vtkSetClampMacro(Length, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Length, double);
  ///@}

  ///@{
  /**
   * The distance between points of the noise's lattice, in units of length. Default 0: 1/128 of the
   * diagonal of the bounds of port 0. Valid: 0 and above; clamped.
   */
  vtkSetClampMacro(NoiseScale, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(NoiseScale, double);
  ///@}

  ///@{
  /**
   * The length of a step along a streamline, in units of length; shortened so that Length is a
   * whole number of them. Default 0: a quarter of NoiseScale. Valid: 0 and above; clamped.
   */
  vtkSetClampMacro(StepLength, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(StepLength, double);
  ///@}

  ///@{
  /**
   * The seed of the noise. Default 0. Valid: any number.
   */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

  ///@{
  /**
   * The standard deviation of the output. Default 0.2, with which 1.2 % of a normal distribution
   * are held to 0 and 1. Valid: 0 to 1; clamped.
   */
  vtkSetClampMacro(Contrast, double, 0.0, 1.0);
  vtkGetMacro(Contrast, double);
  ///@}

  /**
   * Returns what the last execution did:
   * - Points: points of the output,
   * - PointsOutside: points outside of the field, whose value is 0,
   * - PointsAtRest: points in the field whose velocity is not finite or below 1e-9 of the largest,
   * - PointsWithShortLines: other points in the field whose streamline ends before Length,
   * - Steps: steps each way of a full streamline,
   * - StepLength, Length, NoiseScale: the lengths in use, also if the settings are automatic,
   * - FillValues: points of the field with vectors that look like fill values,
   * - NonFiniteVectors: points of the field's cells with vectors that are NaN or infinite.
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

  /// Fills the lengths and the number of steps in the report. Returns an error if there are too
  /// many steps.
  interlume::Error FindSteps(vtkDataSet* points, interlume::FlowLICReport& report) const;
  template <typename Walker>
  void Convolve(
    const Walker& walker, vtkDataSet* points, float* values, interlume::FlowLICReport& report);

  int Kernel = HANN;
  double Length = 0.0;
  double NoiseScale = 0.0;
  double StepLength = 0.0;
  int Seed = 0;
  double Contrast = 0.2;
  vtkNew<vtkInterlumeReport> Report;
  /// What was found of the last field's mesh, for the next execution.
  std::shared_ptr<const interlume::MeshLinks> Mesh;
};

#endif
