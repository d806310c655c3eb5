// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkTetrahedralMesher_h
#define vtkTetrahedralMesher_h

#include "InterlumeMeshingModule.h" // for the export macro
#include "vtkInterlumeReport.h"     // for GetReport()
#include "vtkMeshingSettings.h"     // for what is set
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
 * @brief   tetrahedra of closed surfaces, of point sets, and of the cells of a grid, by TetGen
 *
 * The mesh that is made depends on the cells of the input:
 *
 * - Cells of three dimensions (a vtkUnstructuredGrid with polyhedra, any other grid): every cell is
 *   decomposed. Polyhedra may be concave and their faces may be concave or not planar. The mesh is
 *   conforming: a face is cut into triangles by a rule that depends on its own points alone, so two
 *   cells agree on the face they share, whatever their types, and no face or edge gets a new point.
 *   (The order of the points is that of the point data's global ids, integers of any type, if there
 *   are some, otherwise of the point ids.) A cell that is not convex may get new points inside. The
 * bounds below do not apply. Tetrahedra, voxels, hexahedra, wedges, pyramids, pentagonal and
 * hexagonal prisms and polyhedra are taken; other cells, ghosts and hidden cells are left out and
 * counted in GetReport().
 * - Polygons, and no such cells (vtkPolyData; triangles, quads, polygons, pixels and strips): the
 *   space within the closed surface is filled. Several shells may lie beside and within each other;
 *   see FillNestedShells, and touch, see SplitContacts. Points in the same place count as one.
 * Vertices and lines are not used.
 * - Points alone (any vtkPointSet without polygons): the Delaunay tetrahedra of their convex hull.
 *   With a bound set, this mesh is refined.
 *
 * Output: VTK_TETRA cells of positive volume, points in double. The input's points that are used
 * keep their places and order, new points follow. Arrays:
 *
 * - every numeric point array. Points of the input keep their values. A new point on a polygon has
 *   the linear interpolation on its triangle; one that refines a point set has that of the Delaunay
 *   tetrahedron of the input's points that it lies in; one inside a surface or a cell has the value
 *   of the discrete harmonic function on the mesh: the smoothest continuation, linear on each
 *   tetrahedron, that has the given values at all other points. Each of them reproduces linear
 *   functions. Integers come out as float (8 and 16 bits) or double. Global ids, pedigree ids,
 * ghosts and strings are left out.
 * - from cells: every cell array, copied from the cell a tetrahedron comes from.
 * - from surfaces: cell array `RegionId` (int), see FillNestedShells.
 *
 * The same input gives the same bytes.
 *
 * TetGen (H. Si, "TetGen, a Delaunay-based quality tetrahedral mesh generator", ACM TOMS 41(2),
 * 2015) runs in a process of its own: whatever it does there, it throws, exits, crashes or never
 * ends, comes back as an error. Abort is honoured at any time; while TetGen works, progress stands
 * still.
 *
 * Errors (vtkErrorMacro, empty output), with the number of the cell or point: a coordinate that is
 * not finite; a cell with fewer points than its type needs, or with points that do not exist; a
 * surface that is open or intersects itself; a polygon that meets itself or has no area; points in
 * one plane; a cell without volume, with faces that are not closed, or that cannot be decomposed;
 * global ids that are not one integer for each point; TetGen's own failures. Warnings: tetrahedra
 * that exceed a bound, next to small angles of the input or where PreserveBoundary or
 * MaximumNumberOfAddedPoints leaves no choice; cells of a type that is not taken; an output without
 * tetrahedra and why, once for a composite input, unless WarnOnEmptyOutput is off or it is one
 * piece of several.
 *
 * TetGen is under the AGPL: this module is optional (INTERLUME_ENABLE_TETGEN).
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
   * The largest ratio of a tetrahedron's circumscribed radius to its shortest edge, for surfaces
   * and point sets. 0: no bound, and no new point but those that the surface needs. Smaller is
   * better shaped; a regular tetrahedron has 0.612. The bound is held where no angle between edges
   * or faces of the surface is below some 60 degrees, and best from 1.2 on; elsewhere a warning
   * counts what exceeds it, or TetGen does not end, see TimeLimit. Default 0; valid 0, and 1 to
   * 1000 (less than 1 becomes 1).
   */
  void SetQualityBound(double bound);
  vtkGetMacro(QualityBound, double);
  ///@}

  ///@{
  /**
   * The dihedral angle, in degrees, that TetGen tries to reach in every tetrahedron, on top of
   * QualityBound; without that it does not apply. It may be missed, unlike a bound. Default 0;
   * valid 0 to 30.
   */
  vtkSetClampMacro(MinimumDihedralAngle, double, 0.0, 30.0);
  vtkGetMacro(MinimumDihedralAngle, double);
  ///@}

  ///@{
  /**
   * The largest volume of a tetrahedron, in cubes of the unit of length, for surfaces and point
   * sets; 0 for none. Without QualityBound TetGen keeps to a bound of 2 while it refines. The bound
   * is held: what TetGen leaves above it is bisected at longest edges, until
   * MaximumNumberOfAddedPoints. It may be as small as the model requires: the mesh does not depend
   * on the unit of length. Default 0; valid 0 and more.
   */
  vtkSetClampMacro(MaximumVolume, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumVolume, double);
  ///@}

  ///@{
  /**
   * The largest number of points that a bound may add, which ends a refinement that would not end
   * otherwise. Default 2000000; valid 0 to 100000000. (A tetrahedron mesh has five to six times as
   * many tetrahedra as points; TetGen needs about a kilobyte a point.)
   */
  vtkSetClampMacro(MaximumNumberOfAddedPoints, int, 0, 100000000);
  vtkGetMacro(MaximumNumberOfAddedPoints, int);
  ///@}

  ///@{
  /**
   * Whether the triangles of a surface, or of the convex hull of a point set, stay as they are.
   * Then the bounds cannot be held near them. Off, they may be divided; their shape does not
   * change. Default off.
   */
  vtkSetMacro(PreserveBoundary, bool);
  vtkGetMacro(PreserveBoundary, bool);
  vtkBooleanMacro(PreserveBoundary, bool);
  ///@}

  ///@{
  /**
   * Whether shells within a shell are filled too. Off: a shell within a shell bounds a cavity, a
   * shell within that a solid again, and so on; the orientation of the polygons does not matter.
   * On: everything within is filled. In both cases each region between the shells has its own
   * `RegionId`, counted from 0 in the order of the first input cell that bounds the region, of two
   * with the same cell the outer one first. A wall that two parts share belongs to both, and counts
   * as a cell of the later one: a part between others is no cavity. Default off.
   */
  vtkSetMacro(FillNestedShells, bool);
  vtkGetMacro(FillNestedShells, bool);
  vtkBooleanMacro(FillNestedShells, bool);
  ///@}

  ///@{
  /**
   * If true, triangles of a surface are split where they touch others without common points or
   * edges: parts that stand on each other, cross along edges or share a wall with other diagonals.
   * The parts then share points and triangles there, and each keeps its region. Touching is meant
   * within the rounding of the coordinates. GetReport() has the number of triangles that were
   * split. If false, such a contact is an error that names the two cells. Default on.
   */
  vtkSetMacro(SplitContacts, bool);
  vtkGetMacro(SplitContacts, bool);
  vtkBooleanMacro(SplitContacts, bool);
  ///@}

  ///@{
  /**
   * The longest time that TetGen may take for one surface, point set or cell, in seconds; 0 for no
   * limit. Beyond it TetGen is ended, with an error. Default 600; valid 0 and more.
   */
  vtkSetClampMacro(TimeLimit, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(TimeLimit, double);
  ///@}

  ///@{
  /**
   * The program that runs TetGen; empty for the one installed beside this module's library. Needed
   * only where the modules are linked statically or moved apart. Default empty.
   */
  vtkSetMacro(WorkerFileName, std::string);
  vtkGetMacro(WorkerFileName, std::string);
  ///@}

  ///@{
  /**
   * Whether an execution that gives nothing warns, and says why. Default on.
   */
  vtkSetMacro(WarnOnEmptyOutput, bool);
  vtkGetMacro(WarnOnEmptyOutput, bool);
  vtkBooleanMacro(WarnOnEmptyOutput, bool);
  ///@}

  /**
   * Returns the report of the last execution:
   * - Tetrahedra, Regions: numbers of the output's cells and of its values of `RegionId`
   * - AddedPoints: points of the output that the input does not have
   * - SkippedCells: cells skipped because they are ghosts, hidden or of fewer dimensions
   * - UnsupportedCells: cells skipped because of their type
   * - MergedPoints: points of a surface or point set merged with one at the same position
   * - SplitTriangles: triangles of a surface split by SplitContacts
   * - TetrahedraAboveQualityBound, TetrahedraAboveMaximumVolume: tetrahedra that exceed a bound
   * - LargestRadiusEdgeRatio: the largest ratio that QualityBound limits
   */
  vtkInterlumeReport* GetReport() { return this->Report; }

protected:
  vtkTetrahedralMesher();
  ~vtkTetrahedralMesher() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  /// Runs the mesher that the input asks for.
  interlume::Error Mesh(interlume::MeshingJob& job);
  /// Turns the mesh of \a job into \a output.
  void TakeOutput(interlume::MeshingJob& job, vtkUnstructuredGrid* output);
  void Warn(const interlume::MeshingJob& job);
  ///@{
  /// Begins and ends an execution, over one dataset or over all: the pipeline sends a pair of
  /// events for each dataset of a composite input, within a pair for the whole.
  void BeginExecution();
  void WarnIfEmpty();
  ///@}

private:
  vtkTetrahedralMesher(const vtkTetrahedralMesher&) = delete;
  void operator=(const vtkTetrahedralMesher&) = delete;

  bool WarnOnEmptyOutput = true;
  vtkNew<vtkInterlumeReport> Report;
  /// Whether the execution has made no tetrahedron so far, and no error has said why.
  bool IsEmpty = true;
  int Depth = 0;
};

#endif
