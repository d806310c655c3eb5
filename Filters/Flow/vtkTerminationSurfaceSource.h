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
 * @brief   a termination surface as triangles, to be drawn
 *
 * Each part is drawn as a grid over (u,v), 0 to 1. Where the part has no point for some parameters
 * (vtkTerminationSurface::EvaluatePoint) the grid is cut at the border, found by bisection. At the
 * seam of a periodic direction there are points at 0 and at 1. An unbounded plane is drawn as its
 * parallelogram.
 *
 * Output: triangles with the point arrays `TerminationUV` (double, 2 components), also the active
 * texture coordinates and scalars, and `Normals` (double), those of the surface, also the active
 * normals, and the cell array `TerminationId` (int): the surface's id, 0 for -1, plus the part.
 * Triangles are counterclockwise seen from where the normals point.
 *
 * Errors (vtkErrorMacro, empty output): no surface; what vtkTerminationSurface::Update reports.
 */
class INTERLUMEFLOW_EXPORT vtkTerminationSurfaceSource : public vtkPolyDataAlgorithm
{
public:
  static vtkTerminationSurfaceSource* New();
  vtkTypeMacro(vtkTerminationSurfaceSource, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The surface that is drawn. Default null.
   */
  void SetSurface(vtkTerminationSurface* surface);
  vtkTerminationSurface* GetSurface() const;
  ///@}

  ///@{
  /**
   * The number of cells of the grid along u and v. Default 32, 32. Valid: 1 to 10000, clamped.
   */
  vtkSetClampMacro(ResolutionU, int, 1, 10000);
  vtkGetMacro(ResolutionU, int);
  vtkSetClampMacro(ResolutionV, int, 1, 10000);
  vtkGetMacro(ResolutionV, int);
  ///@}

  /// Returns the time of the last change, of the surface too.
  vtkMTimeType GetMTime() override;

  /**
   * Returns what the last execution drew:
   * - Parts: parts of the surface,
   * - Points: points of the output,
   * - BorderPoints: those among them that were found on the border of a part, between grid nodes,
   * - Triangles: triangles of the output,
   * - FlatTriangles: triangles without area that were left out, as at the poles of a sphere.
   *
   * Every number is 0 after an execution that failed or was aborted.
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
