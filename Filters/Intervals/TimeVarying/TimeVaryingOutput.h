// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TimeVaryingOutput_h
#define interlume_TimeVaryingOutput_h

class vtkUnstructuredGrid;

namespace interlume
{

struct TimeVaryingReport;

class TimeVaryingMesh;
struct ExtractionContext;

/**
 * @class   TimeVaryingOutput
 * @brief   makes the outputs of a finished mesh of 4-simplices
 *
 * The counts of what is made are added to the report.
 */
class TimeVaryingOutput
{
public:
  /// Makes the tetrahedra of all projections, with the points of the mesh and one thick point for
  /// each 4-simplex after them. Returns false when the user aborted.
  static bool FillTetrahedra(const ExtractionContext& context, const TimeVaryingMesh& mesh,
    vtkUnstructuredGrid* output, TimeVaryingReport& report);
  /// Makes the boundary, with the points of the mesh.
  static void FillBoundary(
    const TimeVaryingMesh& mesh, vtkUnstructuredGrid* output, TimeVaryingReport& report);
  /// Makes the 4-simplices, with the points of the mesh.
  static void FillSimplices(const TimeVaryingMesh& mesh, vtkUnstructuredGrid* output);
};

}

#endif
