// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkTerminationSurfaceSource_h
#define vtkTerminationSurfaceSource_h

#include "InterlumeFlowModule.h" // for the export macro
#include "vtkInterlumeReport.h"  // for GetReport()
#include "vtkNew.h"              // for the report
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h" // for the surface

class vtkTerminationSurface;

/**
 * @class   vtkTerminationSurfaceSource
 * @brief   triangulate a termination surface for display
 *
 * Creates a grid over (u,v), 0 to 1, for each part of the surface. Where
 * vtkTerminationSurface::EvaluatePoint returns false, the grid is trimmed at the boundary, found by
 * bisection. A periodic direction has points at both 0 and 1. An unbounded plane is displayed as
 * its parallelogram.
 *
 * Output: triangles with the point arrays `TerminationUV` (double, 2 components; active texture
 * coordinates and scalars) and `Normals` (double; active normals), and the cell array
 * `TerminationId` (int: the surface's id, or 0 if the id is -1, plus the index of the part).
 * Triangles are counterclockwise as seen from the side of the normal.
 *
 * Errors (vtkErrorMacro, empty output): no surface; a surface rejected by
 * vtkTerminationSurface::Update.
 */
class INTERLUMEFLOW_EXPORT vtkTerminationSurfaceSource : public vtkPolyDataAlgorithm
{
public:
  static vtkTerminationSurfaceSource* New();
  vtkTypeMacro(vtkTerminationSurfaceSource, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Surface to triangulate. Default: null.
   */
  void SetSurface(vtkTerminationSurface* surface);
  vtkTerminationSurface* GetSurface() const;
  ///@}

  ///@{
  /**
   * Number of grid cells along u and v. Default: 32, 32. Valid: 1 to 10000; clamped.
   */
  vtkSetClampMacro(ResolutionU, int, 1, 10000);
  vtkGetMacro(ResolutionU, int);
  vtkSetClampMacro(ResolutionV, int, 1, 10000);
  vtkGetMacro(ResolutionV, int);
  ///@}

  /// Return the modification time, including that of the surface.
  vtkMTimeType GetMTime() override;

  /**
   * Return the report of the last execution, all 0 if it failed or was aborted:
   * - Parts: parts of the surface,
   * - Points: points of the output,
   * - BorderPoints: points on the boundary of a part, between grid nodes,
   * - Triangles: triangles of the output,
   * - FlatTriangles: skipped triangles of zero area, for example at the poles of a sphere.
   */
  vtkInterlumeReport* GetReport() { return this->Report; }

protected:
  vtkTerminationSurfaceSource();
  ~vtkTerminationSurfaceSource() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkTerminationSurfaceSource(const vtkTerminationSurfaceSource&) = delete;
  void operator=(const vtkTerminationSurfaceSource&) = delete;

  vtkSmartPointer<vtkTerminationSurface> Surface;
  int ResolutionU = 32;
  int ResolutionV = 32;
  vtkNew<vtkInterlumeReport> Report;
};

#endif
