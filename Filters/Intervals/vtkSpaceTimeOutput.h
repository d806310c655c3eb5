#ifndef vtkSpaceTimeOutput_h
#define vtkSpaceTimeOutput_h

struct vtkExtractionContext;
class vtkSpaceTimeMesh;
class vtkUnstructuredGrid;
struct vtkSpaceTimeReport;

/**
 * @class   vtkSpaceTimeOutput
 * @brief   makes the outputs of a finished mesh of 4-simplices
 *
 * The counts of what is made are added to the report.
 */
class vtkSpaceTimeOutput
{
public:
  /// The tetrahedra of all projections, with the points of the mesh and one thick point for each
  /// 4-simplex after them. Returns false when the user aborted.
  static bool FillTetrahedra(const vtkExtractionContext& context, const vtkSpaceTimeMesh& mesh,
    vtkUnstructuredGrid* output, vtkSpaceTimeReport& report);
  /// The boundary, with the points of the mesh.
  static void FillBoundary(
    const vtkSpaceTimeMesh& mesh, vtkUnstructuredGrid* output, vtkSpaceTimeReport& report);
  /// The 4-simplices, with the points of the mesh.
  static void FillSimplices(const vtkSpaceTimeMesh& mesh, vtkUnstructuredGrid* output);
};

#endif
