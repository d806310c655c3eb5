// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkTerminationSurfaceSourceReport_h
#define vtkTerminationSurfaceSourceReport_h

#include "InterlumeFlowModule.h" // for the export macro
#include "vtkIndent.h"
#include "vtkType.h"

#include <ostream>

/**
 * @class   vtkTerminationSurfaceSourceReport
 * @brief   what the last execution of vtkTerminationSurfaceSource drew
 *
 * This is a plain value object. Every number is 0 before the first execution and after one that
 * failed or was aborted.
 *
 * @sa vtkTerminationSurfaceSource
 */
struct INTERLUMEFLOW_EXPORT vtkTerminationSurfaceSourceReport
{
  /// The number of parts of the surface.
  int Parts = 0;
  /// The numbers of points of the output, and of those among them that were found on the border of
  /// a part, between nodes of its grid.
  vtkIdType Points = 0;
  vtkIdType BorderPoints = 0;
  /// The numbers of triangles of the output, and of those that were left out because they have no
  /// area, as at the poles of a sphere.
  vtkIdType Triangles = 0;
  vtkIdType FlatTriangles = 0;

  void Print(std::ostream& os, vtkIndent indent) const;
};

#endif
