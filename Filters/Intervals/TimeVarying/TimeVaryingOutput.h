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
 * @brief   creates the outputs from a finished mesh of 4-simplices
 *
 * The numbers of tetrahedra and boundary cells created are added to the report.
 */
class TimeVaryingOutput
{
public:
  /// Creates the tetrahedra of all projected 4-simplices. The output has the points of the mesh,
  /// followed by one thick point, where DeltaT is nonzero, per 4-simplex that is not degenerate.
  /// Returns false if the user aborted.
  static bool FillTetrahedra(const ExtractionContext& context, const TimeVaryingMesh& mesh,
    vtkUnstructuredGrid* output, TimeVaryingReport& report);
  /// Returns the peak size in bytes of a mesh and its outputs, if the mesh has \a tetrahedra
  /// tetrahedra.
  static double EstimateBytes(const TimeVaryingMesh& mesh, double tetrahedra);
  /// Creates the boundary cells, with the points of the mesh.
  static void FillBoundary(
    const TimeVaryingMesh& mesh, vtkUnstructuredGrid* output, TimeVaryingReport& report);
  /// Creates the 4-simplices, with the points of the mesh.
  static void FillSimplices(const TimeVaryingMesh& mesh, vtkUnstructuredGrid* output);
};

}

#endif
