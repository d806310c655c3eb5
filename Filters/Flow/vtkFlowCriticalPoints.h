// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkFlowCriticalPoints_h
#define vtkFlowCriticalPoints_h

#include "InterlumeFlowModule.h" // for the export macro
#include "vtkInterlumeReport.h"  // for GetReport()
#include "vtkNew.h"              // for the report
#include "vtkPolyDataAlgorithm.h"

/**
 * @class   vtkFlowCriticalPoints
 * @brief   where the field vanishes, and what it does around there
 *
 * The zeros of the interpolated vectors in each cell: on tetrahedra by solving the linear system,
 * elsewhere by subdividing the cell until the vectors' bounds exclude zero or Newton's method
 * converges. It finds all zeros, several in a cell too. A zero on a face or a point that cells
 * share is one point, with the Jacobian of the cell of least id. Cells in which the field is 0
 * throughout have none, and are counted; so are cells with lines or surfaces of zeros, as along the
 * axis of a rotation (see vtkVortexAxis), on walls, or in a plane flow. Zeros at points of such
 * cells are part of them and none either.
 *
 * Cells that are blanked, hidden or ghosts are left out, those that are not finite too.
 *
 * Input: as vtkImplicitFlowField's port 0: vtkImageData, vtkRectilinearGrid, vtkStructuredGrid, or
 * vtkUnstructuredGrid of tetrahedra, voxels, hexahedra, wedges and pyramids; point vectors, by
 * default the active ones.
 * Output: vertices with the point arrays `CriticalPointType` (int), `Eigenvalues` (double, 6
 * components: three complex numbers, by descending real part), `Jacobian` (double, 9, dv_i/dx_j at
 * 3 i + j), `CellLength` (double: the cube root of the cell's volume) and `CellId`.
 *
 * The same bytes for any number of threads.
 *
 * Warnings (vtkWarningMacro): no critical point, with how many cells have zeros that are none;
 * cells that were skipped because vectors look like fill values (as for
 * vtkImplicitFlowField::SetMaximumError), with the value, or are NaN or infinite.
 *
 * Errors (vtkErrorMacro, empty output): points without cells, unless in one piece of several; no
 * vectors of that name, or not of three components; cells of other types, two-dimensional grids
 * among them.
 */
class INTERLUMEFLOW_EXPORT vtkFlowCriticalPoints : public vtkPolyDataAlgorithm
{
public:
  static vtkFlowCriticalPoints* New();
  vtkTypeMacro(vtkFlowCriticalPoints, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The type of a critical point, which follows from the signs of the eigenvalues' real parts;
  /// spirals have a complex pair. A real or imaginary part below 1e-9 of the largest absolute value
  /// is 0. With a real part of 0 the point is DEGENERATE, or a CENTER where the pair is imaginary.
  /// Where the Jacobian is singular, or the cell flat, the point is DEGENERATE.
  enum Types
  {
    DEGENERATE = 0,
    SOURCE = 1,
    SPIRAL_SOURCE = 2,
    /// A saddle with one incoming and two outgoing directions.
    SADDLE_1_IN = 3,
    SPIRAL_SADDLE_1_IN = 4,
    /// A saddle with two incoming and one outgoing direction.
    SADDLE_2_IN = 5,
    SPIRAL_SADDLE_2_IN = 6,
    SINK = 7,
    SPIRAL_SINK = 8,
    CENTER = 9,
    NUMBER_OF_TYPES = 10
  };
  static const char* GetTypeName(int type);

  /**
   * Returns what the last execution did:
   * - ZeroCells: cells in which the field is 0 throughout,
   * - DegenerateCells: cells with zeros that are not isolated,
   * - NonFiniteCells: cells that were skipped because they are not finite,
   * - FillValueCells: cells that were skipped because a point has fill values.
   */
  vtkInterlumeReport* GetReport() { return this->Report; }

protected:
  vtkFlowCriticalPoints();
  ~vtkFlowCriticalPoints() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkFlowCriticalPoints(const vtkFlowCriticalPoints&) = delete;
  void operator=(const vtkFlowCriticalPoints&) = delete;

  vtkNew<vtkInterlumeReport> Report;
};

#endif
