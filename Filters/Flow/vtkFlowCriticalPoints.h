// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkFlowCriticalPoints_h
#define vtkFlowCriticalPoints_h

#include "InterlumeFlowModule.h" // for the export macro
#include "vtkInterlumeReport.h"  // for GetReport()
#include "vtkNew.h"              // for the report
#include "vtkPolyDataAlgorithm.h"

/**
 * @class   vtkFlowCriticalPoints
 * @brief   find and classify the zeros of a vector field
 *
 * Finds all isolated zeros of the interpolated vectors in each cell. A tetrahedron requires the
 * solution of one linear system. Other cells are subdivided until bounds of the vectors exclude
 * zero or Newton's method converges. A zero on a face, edge or point between cells is reported
 * once, with the Jacobian of the cell with the lowest id. See
 * Documentation/methods/implicit-flow.md.
 *
 * Cells where the field is 0 throughout have no critical point, and neither do cells with lines or
 * surfaces of zeros, for example on the axis of a rotation (see vtkVortexAxis), on walls, or in
 * plane flow. The report counts both kinds of cells. Zeros at points of such cells belong to the
 * line or surface and are not reported. Blanked, hidden and ghost cells are skipped, and so are
 * cells with vectors that are not finite.
 *
 * Input: vtkImageData, vtkRectilinearGrid, vtkStructuredGrid, or vtkUnstructuredGrid of tetrahedra,
 * voxels, hexahedra, wedges and pyramids, with vectors of three components; by default the active
 * vectors. Cell vectors are averaged at the points, as in vtkImplicitFlowField.
 *
 * Output: vertices with the point arrays `CriticalPointType` (int, the active scalars),
 * `Eigenvalues` (double, 6 components: three complex numbers by descending real part), `Jacobian`
 * (double, 9 components: dv_i/dx_j at index 3 * i + j), `CellLength` (double: cube root of the
 * cell's volume) and `CellId`. The output is identical for any number of threads.
 *
 * Warnings (vtkWarningMacro): no critical point, with the reasons; cells that were skipped because
 * vectors look like fill values (see vtkImplicitFlowField::SetMaximumError), or are NaN or
 * infinite.
 *
 * Errors (vtkErrorMacro, empty output): points without cells, unless the input is one of several
 * pieces; missing vectors, or vectors without three components; unsupported cells, including
 * two-dimensional grids.
 *
 * @sa vtkImplicitFlowField vtkVortexAxis
 */
class INTERLUMEFLOW_EXPORT vtkFlowCriticalPoints : public vtkPolyDataAlgorithm
{
public:
  static vtkFlowCriticalPoints* New();
  vtkTypeMacro(vtkFlowCriticalPoints, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Type of a critical point, determined by the signs of the real parts of its eigenvalues.
  /// Spirals have a complex-conjugate pair. A real or imaginary part below 1e-9 of the largest
  /// eigenvalue's magnitude counts as 0. A zero real part makes the point DEGENERATE, or a CENTER
  /// if the pair is imaginary. The point is also DEGENERATE if the Jacobian is singular or the cell
  /// has no volume.
  enum Types
  {
    DEGENERATE = 0,
    SOURCE = 1,
    SPIRAL_SOURCE = 2,
    /// Saddle with one incoming and two outgoing directions.
    SADDLE_1_IN = 3,
    SPIRAL_SADDLE_1_IN = 4,
    /// Saddle with two incoming and one outgoing direction.
    SADDLE_2_IN = 5,
    SPIRAL_SADDLE_2_IN = 6,
    SINK = 7,
    SPIRAL_SINK = 8,
    CENTER = 9,
    NUMBER_OF_TYPES = 10
  };
  static const char* GetTypeName(int type);

  /**
   * Return the report of the last execution:
   * - ZeroCells: cells in which the field is 0 throughout,
   * - DegenerateCells: cells with zeros that are not isolated,
   * - NonFiniteCells: cells skipped because vectors are not finite,
   * - FillValueCells: cells skipped because a point has fill values,
   * - ConvertedCellArrays: name of the vectors if they are a cell array.
   */
  vtkInterlumeReport* GetReport() { return this->Report; }

protected:
  vtkFlowCriticalPoints();
  ~vtkFlowCriticalPoints() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkFlowCriticalPoints(const vtkFlowCriticalPoints&) = delete;
  void operator=(const vtkFlowCriticalPoints&) = delete;

  vtkNew<vtkInterlumeReport> Report;
};

#endif
