// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkTetrahedralMesher_h
#define vtkTetrahedralMesher_h

#include "InterlumeMeshingModule.h" // for the export macro
#include "vtkInterlumeReport.h"     // for GetReport()
#include "vtkMeshingSettings.h"     // settings
#include "vtkNew.h"                 // for the report
#include "vtkUnstructuredGridAlgorithm.h"

#include <string> // for the worker's name

namespace interlume
{
class Error;
struct MeshingJob;
}

/**
 * @class   vtkTetrahedralMesher
 * @brief   generate tetrahedra from closed surfaces, point sets or cells, using TetGen
 *
 * The cells of the input determine the kind of mesh:
 *
 * - Three-dimensional cells: each cell is decomposed into tetrahedra. Polyhedra may be concave, and
 *   their faces may be concave or non-planar. The mesh is conforming: adjacent cells split their
 *   common face into the same triangles, and faces and edges get no new points. A cell that is not
 *   convex may get new points inside. Tetrahedra, voxels, hexahedra, wedges, pyramids, pentagonal
 *   and hexagonal prisms and polyhedra are supported. Coincident points of one cell are merged, so
 *   its faces may be collapsed. Other cells, ghost cells and hidden cells are
 *   skipped and counted in GetReport(). The quality and volume bounds do not apply.
 * - Polygons (triangles, quads, polygons, pixels, strips) and no three-dimensional cells: the
 *   volume inside the closed surface is filled. The surface may have several shells, which may be
 *   disjoint, nested (see FillNestedShells) or touching (see SplitContacts). Coincident points are
 *   merged. Vertices and lines are ignored.
 * - Neither polygons nor three-dimensional cells: the Delaunay tetrahedralization of the points is
 *   generated, and refined if a bound is set.
 *
 * The output has VTK_TETRA cells of positive volume and points of type double. Used input points
 * come first, in input order, followed by new points. Equal inputs give bit-identical outputs.
 * Arrays:
 *
 * - Numeric point arrays are interpolated: input points keep their values, and linear functions are
 *   reproduced at new points. 8-bit and 16-bit integers become float, other integers become double.
 *   Global ids, pedigree ids, ghost arrays and string arrays are not copied.
 * - If the input has three-dimensional cells, each tetrahedron gets the cell array values of its
 *   input cell.
 * - If the input is a surface, the cell array `RegionId` (int) is added (see FillNestedShells).
 *
 * TetGen (H. Si, "TetGen, a Delaunay-based quality tetrahedral mesh generator", ACM TOMS 41(2),
 * 2015) runs in a separate process. If it throws, exits, crashes or exceeds TimeLimit, the filter
 * reports an error. Abort works at any time. Progress does not advance while TetGen runs.
 *
 * Errors (vtkErrorMacro, empty output) name the cell or point:
 * - coordinates that are not finite, or coplanar points
 * - cells with too few points or with point ids that do not exist
 * - open or self-intersecting surfaces
 * - cells that have no volume, whose faces do not form a closed surface, or that cannot be
 *   decomposed
 * - global ids that are not one integer per point
 * - failures of TetGen
 *
 * Warnings: faces that meet themselves (coincident points, crossing edges or no area), which are
 * cleaned and triangulated; tetrahedra that exceed a bound, because of small angles in the input,
 * PreserveBoundary or MaximumNumberOfAddedPoints; unsupported cell types; an empty output (see
 * WarnOnEmptyOutput).
 *
 * TetGen is licensed under the AGPL. Therefore this module is optional (INTERLUME_ENABLE_TETGEN).
 * Documentation/methods/meshing.md describes the method.
 *
 * @sa vtkIntervalVolume vtkDelaunay3D
 */
class INTERLUMEMESHING_EXPORT vtkTetrahedralMesher
  : public vtkUnstructuredGridAlgorithm
  , private vtkMeshingSettings
{
public:
  static vtkTetrahedralMesher* New();
  vtkTypeMacro(vtkTetrahedralMesher, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the maximum ratio of a tetrahedron's circumradius to its shortest edge, for surfaces
   * and point sets. Smaller values give better-shaped tetrahedra; a regular tetrahedron has 0.612.
   * 0 sets no bound and adds only points that the surface requires. TetGen meets the bound if edges
   * and faces of the surface form no angle below about 60 degrees, most reliably with a bound of
   * 1.2 or more. Otherwise, a warning reports the number of tetrahedra that exceed it, or TetGen
   * does not terminate (see TimeLimit). Default: 0. Valid: 0, or 1 to 1000; values between 0 and 1
   * become 1.
   */
  void SetQualityBound(double bound);
  vtkGetMacro(QualityBound, double);
  ///@}

  ///@{
  /**
   * Set/Get the dihedral angle, in degrees, that TetGen aims for in every tetrahedron. It has no
   * effect unless QualityBound is set. It is a target, not a bound: no warning reports smaller
   * angles. Default: 0. Valid: 0 to 30.
   */
  vtkSetClampMacro(MinimumDihedralAngle, double, 0.0, 30.0);
  vtkGetMacro(MinimumDihedralAngle, double);
  ///@}

  ///@{
  /**
   * Set/Get the maximum volume of a tetrahedron, in cubic length units, for surfaces and point
   * sets. 0 sets no bound. Without QualityBound, TetGen uses a quality bound of 2 while it refines.
   * Tetrahedra that TetGen leaves too large are bisected at their longest edges until the bound is
   * met or MaximumNumberOfAddedPoints is reached. The mesh does not depend on the unit of length,
   * so the bound may be arbitrarily small. Default: 0. Valid: at least 0.
   */
  vtkSetClampMacro(MaximumVolume, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumVolume, double);
  ///@}

  ///@{
  /**
   * Set/Get the maximum number of points that refinement may add. It stops refinements that would
   * not terminate. Default: 2000000. Valid: 0 to 100000000.
   */
  vtkSetClampMacro(MaximumNumberOfAddedPoints, int, 0, 100000000);
  vtkGetMacro(MaximumNumberOfAddedPoints, int);
  ///@}

  ///@{
  /**
   * Turn on/off preservation of the triangles of the surface, or of the convex hull of a point
   * set. If on, tetrahedra next to them may exceed QualityBound or MaximumVolume. If off, triangles
   * may be subdivided without changing the shape of the surface. Default: off.
   */
  vtkSetMacro(PreserveBoundary, bool);
  vtkGetMacro(PreserveBoundary, bool);
  vtkBooleanMacro(PreserveBoundary, bool);
  ///@}

  ///@{
  /**
   * Turn on/off filling of nested shells. If off, a shell inside a shell bounds a cavity, a shell
   * inside the cavity bounds a solid, and so on; the orientation of the polygons does not matter.
   * If on, everything inside the outer shells is filled. In both cases each region between shells
   * has its own `RegionId`. Regions are numbered from 0 by the first input cell on their boundary;
   * of two regions with the same cell, the outer region is first. A wall shared by two parts
   * belongs to both. Therefore a part enclosed by other parts is not a cavity. Default: off.
   */
  vtkSetMacro(FillNestedShells, bool);
  vtkGetMacro(FillNestedShells, bool);
  vtkBooleanMacro(FillNestedShells, bool);
  ///@}

  ///@{
  /**
   * Turn on/off splitting of surface triangles that touch other triangles without sharing points or
   * edges: parts that rest on each other, that cross along edges, or that share a wall with
   * different diagonals. The parts then share points and triangles at the contact, and each part
   * keeps its region. Triangles touch if their distance is within the rounding error of the
   * coordinates. GetReport() has the number of split triangles. If off, a contact is an error that
   * names the two cells. Default: on.
   */
  vtkSetMacro(SplitContacts, bool);
  vtkGetMacro(SplitContacts, bool);
  vtkBooleanMacro(SplitContacts, bool);
  ///@}

  ///@{
  /**
   * Set/Get the maximum time that TetGen may take for one surface, point set or cell, in seconds. 0
   * sets no limit. When the limit is exceeded, TetGen is stopped and an error is reported. Default:
   * 600. Valid: at least 0.
   */
  vtkSetClampMacro(TimeLimit, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(TimeLimit, double);
  ///@}

  ///@{
  /**
   * Set/Get the path of the program that runs TetGen. If empty, the program next to this module's
   * library is used. Set it if the module is linked statically or was moved away from the program.
   * Default: empty.
   */
  vtkSetMacro(WorkerFileName, std::string);
  vtkGetMacro(WorkerFileName, std::string);
  ///@}

  ///@{
  /**
   * Turn on/off the warning about an output without tetrahedra. A composite input causes at most
   * one warning. A piece of a partitioned dataset causes no warning. Default: on.
   */
  vtkSetMacro(WarnOnEmptyOutput, bool);
  vtkGetMacro(WarnOnEmptyOutput, bool);
  vtkBooleanMacro(WarnOnEmptyOutput, bool);
  ///@}

  /**
   * Returns the report of the last execution:
   * - Tetrahedra, Regions: number of output cells and of `RegionId` values
   * - AddedPoints: number of output points that are not input points
   * - SkippedCells: number of ghost, hidden or lower-dimensional cells
   * - UnsupportedCells: number of cells of unsupported type
   * - MergedPoints: number of points that were merged with a coincident point of the surface, the
   *   point set or the cell
   * - FoldedFaces: number of faces that intersect themselves or have no area
   * - SplitTriangles: number of surface triangles split by SplitContacts
   * - TetrahedraAboveQualityBound, TetrahedraAboveMaximumVolume: number of tetrahedra that exceed a
   *   bound
   * - LargestRadiusEdgeRatio: largest ratio of circumradius to shortest edge
   */
  vtkInterlumeReport* GetReport() { return this->Report; }

protected:
  vtkTetrahedralMesher();
  ~vtkTetrahedralMesher() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  /// Runs the mesher for the kind of cells in the input.
  interlume::Error Mesh(interlume::MeshingJob& job);
  /// Copies the mesh of \a job to \a output and computes its arrays.
  void FillOutput(interlume::MeshingJob& job, vtkUnstructuredGrid* output);
  void Warn(const interlume::MeshingJob& job);
  ///@{
  /// Called at the start and the end of an execution. For composite input, the pipeline sends start
  /// and end events for each dataset, between the start and end events for the whole input.
  void BeginExecution();
  void WarnIfEmpty();
  ///@}

private:
  vtkTetrahedralMesher(const vtkTetrahedralMesher&) = delete;
  void operator=(const vtkTetrahedralMesher&) = delete;

  bool WarnOnEmptyOutput = true;
  vtkNew<vtkInterlumeReport> Report;
  /// True if the current execution has generated no tetrahedron and reported no error.
  bool IsEmpty = true;
  int Depth = 0;
};

#endif
