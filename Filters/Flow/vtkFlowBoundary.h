// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkFlowBoundary_h
#define vtkFlowBoundary_h

#include "InterlumeFlowModule.h" // for the export macro
#include "vtkInterlumeReport.h"  // for GetReport()
#include "vtkNew.h"              // for the report
#include "vtkPolyDataAlgorithm.h"

/**
 * @class   vtkFlowBoundary
 * @brief   divide the boundary of a vector field into inflow and outflow regions
 *
 * The boundary consists of the outer faces of the field's cells: cell faces at seams and between
 * coincident points are inside. Through each face, the flow enters, leaves, or does neither. A
 * region is a set of adjacent faces with the same direction. Edges sharper than 30 degrees divide
 * regions, as they divide the domain faces of vtkImplicitFlowField. Regions are numbered by
 * descending flow rate. A region is a termination surface: pass the output for one Region to
 * vtkTerminationMesh. See Documentation/methods/implicit-flow.md.
 *
 * Input: vtkImageData, vtkRectilinearGrid, vtkStructuredGrid, or vtkUnstructuredGrid of tetrahedra,
 * voxels, hexahedra, wedges and pyramids, with three-component vectors; by default the active
 * vectors. Cell vectors are averaged at the points, as in vtkImplicitFlowField. Hidden, blanked and
 * ghost cells are not part of the field. Lower-dimensional cells and cells without volume are
 * ignored.
 *
 * Output: polygons whose normals point outward, with
 * - the cell arrays `FlowDirection` (int, see Directions; the active scalars), `FlowRate` (double:
 *   integral of the vectors' normal component over the face, positive if the flow leaves) and
 *   `RegionId` (int; -1 for NEITHER),
 * - the point arrays of the vectors and `RegionUV` (double, 2 components; the active texture
 *   coordinates): the coordinates along the two axes most nearly parallel to the region, as
 *   fractions of its bounds; 0 for NEITHER. Regions do not share points,
 * - the field arrays `RegionFlowRate` and `RegionArea` (double), with one value per region.
 *
 * The flow rate is exact for vectors that are linear in a planar face. The filter
 * requests the complete input; in parallel, the first piece is the complete boundary and all others
 * are empty. The output is identical for any number of threads.
 *
 * Warnings (vtkWarningMacro): no flow through the boundary; nonconforming faces, which are part of
 * the boundary; faces that count as NEITHER because vectors look like fill values (see
 * vtkImplicitFlowField::SetMaximumError), or are NaN or infinite.
 *
 * Errors (vtkErrorMacro, empty output): points without cells; missing vectors, or vectors without
 * three components; unsupported cells, including two-dimensional grids; a Region that does not
 * exist.
 *
 * @sa vtkImplicitFlowField vtkTerminationMesh vtkFlowCriticalPoints
 */
class INTERLUMEFLOW_EXPORT vtkFlowBoundary : public vtkPolyDataAlgorithm
{
public:
  static vtkFlowBoundary* New();
  vtkTypeMacro(vtkFlowBoundary, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Directions
  {
    INFLOW = -1,
    NEITHER = 0,
    OUTFLOW = 1
  };

  enum Regions
  {
    ALL = -1
  };
  ///@{
  /**
   * Region to output, by its number. ALL outputs all regions and the faces without flow. Default:
   * ALL. Valid: ALL, and 0 or above.
   */
  vtkSetClampMacro(Region, int, ALL, VTK_INT_MAX);
  vtkGetMacro(Region, int);
  ///@}

  ///@{
  /**
   * Mean normal speed of a face up to which it counts as NEITHER, as a fraction of the largest
   * speed of the field. Default: 0.001. Valid: 0 to 1; clamped.
   */
  vtkSetClampMacro(MinimumNormalSpeed, double, 0.0, 1.0);
  vtkGetMacro(MinimumNormalSpeed, double);
  ///@}

  /**
   * Return the report of the last execution:
   * - InflowRegions, OutflowRegions: number of regions,
   * - InflowRate, OutflowRate: sum of the flow rates of these regions, at least 0,
   * - SkippedFaces: faces with vectors that are not finite or look like fill values,
   * - ConvertedCellArrays: name of the vectors if they are a cell array.
   */
  vtkInterlumeReport* GetReport() { return this->Report; }

protected:
  vtkFlowBoundary();
  ~vtkFlowBoundary() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkFlowBoundary(const vtkFlowBoundary&) = delete;
  void operator=(const vtkFlowBoundary&) = delete;

  int Region = ALL;
  double MinimumNormalSpeed = 1e-3;
  vtkNew<vtkInterlumeReport> Report;
};

#endif
