// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkIntervalVolume_h
#define vtkIntervalVolume_h

#include "InterlumeIntervalsModule.h" // for the export macro
#include "vtkInterlumeReport.h"       // for GetReport()
#include "vtkIntervalAlgorithm.h"
#include "vtkNew.h"          // for the report
#include "vtkSmartPointer.h" // for the value index

#include <memory> // for what is kept
#include <string> // for the criteria
#include <vector> // for the criteria

class vtkDataArray;
class vtkDataSet;

namespace interlume
{
class Error;
class ExtractionIndex;
class ExtractionRun;
class KeptMemory;
struct ExtractionReport;
struct WholePass;
}

/**
 * @class   vtkIntervalVolume
 * @brief   tetrahedra of the region between two isovalues, of any dataset
 *
 * The interval volume { x : lower <= f(x) <= upper } of a scalar point array, made cell by cell by
 * lifting the cell to one dimension more, F(x,w) = f(x) - (lower (1-w) + upper w), taking the
 * isosurface F = 0 there from an isotable and projecting it back (P. Bhaniramka, C. Zhang,
 * D. Xue, R. Crawfis, R. Wenger, "Volume interval segmentation and rendering", IEEE VolVis 2004). A
 * convex piece of a cell is cut into tetrahedra in one global order of the grid's point ids, so
 * that two cells agree on the face they share: no cracks, in mixed meshes too.
 *
 * Input: vtkImageData, vtkRectilinearGrid, vtkStructuredGrid, vtkUnstructuredGrid with tetrahedra,
 * voxels, hexahedra, wedges, pyramids and convex polyhedra, and composite datasets of them. Of
 * quadratic cells the corners are taken, with a warning. A polyhedron that has not the faces of one
 * of the other cells is coned from the mean of its points; where that does not see all of it, since
 * it or a face of it is concave, its parts overlap, with a warning (10.17 instead of 7 for a U of
 * seven cubes). Cells of fewer dimensions, cells with NaN or infinity in the scalar or, with a
 * warning, in a coordinate of a corner, ghost, hidden and blanked cells are left out and counted in
 * GetReport(). The scalar: SetInputArrayToProcess(0, ...), by default the active point scalars, one
 * component.
 *
 * Output port 0: VTK_TETRA cells, and others with KeepWholeCells, in a vtkUnstructuredGrid (a
 * composite input gives a composite output of the same structure), with
 * - every point array, interpolated linearly along the grid edge a point lies on; integers come out
 *   as float (8 and 16 bits) or double; the scalar is the active one;
 * - every cell array, copied from the cell a tetrahedron comes from;
 * - cell array `IntervalId` (int): the index of the interval.
 *
 * Output port 1: the triangles where f equals lower or upper, made only when GenerateBoundaries is
 * on, oriented outward from their interval, with the same point arrays, the cell arrays, and the
 * cell arrays `IntervalId` (int) and `BoundarySide` (int; 0 lower, 1 upper). Its points are
 * those of port 0, with the same ids.
 *
 * Values equal to a bound: f = lower is inside; f = upper is inside unless another interval of
 * this filter that is not of zero width begins at that value. So adjacent intervals of one filter
 * tile the domain without gap or overlap. [a, a] is the cells whose corners are all equal to a,
 * whatever the other intervals are (of a polyhedron that is coned, those of its parts).
 *
 * Faces match, whatever the values: counted with their orientation, the faces of an interval's
 * tetrahedra cancel, but for the triangles of port 1 and those in faces of the domain. (A face of
 * the domain is one with no cell beyond that is taken.) No two tetrahedra have the same points and
 * opposite orientation. Each triangle of port 1 is the face of a tetrahedron, with the cell arrays
 * of its cell; none is there twice, nor turned over as well. Where f equals a bound throughout a
 * face of the domain there is a triangle if that value is outside, as an upper bound is at which
 * another interval begins, and none if it is inside. Triangles of [a, a] are of the lower side
 * where the cell beyond has a value below a, else of the upper one.
 *
 * Pieces of a distributed grid: unstructured ones need global ids in the point data, integers of
 * any type, by which shared faces are cut alike; without them each piece goes by its own ids, and
 * quadrilaterals between two pieces may be cut both ways. Where one of several pieces is asked for,
 * a layer of ghost cells is asked of the input: by them what lies in a face between two pieces,
 * where f equals a bound throughout, is settled as in the whole, and all pieces together have the
 * same simplices to the last bit. Nothing of ghost cells is in the output. Of an input that gives
 * none, such as a file of pieces without them, a face between two pieces is one of the domain for
 * both; and so it is where f equals a bound of a criterion.
 *
 * Whole cells (KeepWholeCells): of each interval the same region, in fewer cells. A cell that is
 * wholly inside an interval, all corners and, of a polyhedron, all points, and within all criteria,
 * is passed on as it is: its type, and its points in their order, left-handed where the input's is;
 * a voxel for a cell of an image or a rectilinear grid (a hexahedron where the image's axes are not
 * those of space), of a quadratic cell the linear one of its corners. Only cells that are cut
 * become tetrahedra, the same as without. A tetrahedron comes out as without in any case, so that
 * on a mesh of tetrahedra nothing changes. Port 0 has the tetrahedra first, then the whole cells,
 * each in the order of the input; port 1 is the same as without. Where a whole cell meets
 * tetrahedra of the same interval, its quadrilateral lies beside two triangles, which have its four
 * points and the diagonal from the first of them in the global order; a polygon with more corners
 * beside a fan from that point. With whole faces cut so, the faces of an interval cancel as above.
 * Where the faces are planar both sides cover the same points, to rounding, and volumes add up as
 * without. A face that is not planar is a bilinear surface to some readers of a whole cell, and two
 * triangles to its neighbour: a gap or an overlap as thick as the face is bent. GetReport() counts
 * the quadrilaterals where that is so, but no larger polygons and nothing between pieces. A concave
 * polyhedron that is whole has its own volume, without the overlap above. Whole cells are no input
 * for vtkTimeWeightedTetrahedraMapper, which says so; vtkIntervalVolume over the scalar's whole
 * range cuts them as it would have at once where there are no global ids.
 *
 * The cells' ids are stored in 32 bits where they fit (vtkCellArray::IsStorage64Bit tells).
 *
 * Point identity: an output point is a grid point, or one isovalue on one grid edge; adjacent
 * intervals share it. The same input gives the same bytes whatever the number of threads.
 *
 * Errors (vtkErrorMacro, empty output): no scalar array of that name, more than one component, a
 * string array, lower > upper, a bound that is not finite or was given as a word, global ids that
 * are not one integer for each point, a cell with fewer points than its type needs, with points
 * that do not exist, or without its faces.
 *
 * Warning (vtkWarningMacro, once for a composite input): an empty output and why, see
 * WarnOnEmptyOutput; a criterion that leaves nothing is a reason too. Warnings for each dataset:
 * quadratic cells, concave polyhedra, cells with a NaN or infinite coordinate, and images and
 * rectilinear grids so far from the origin that output points in single precision are off by more
 * than a hundredth of a cell; cells that are folded or cross themselves, as hexahedra with the
 * point order of voxels do; coordinates of a rectilinear grid that turn back or repeat. Of AMR
 * datasets, whose levels are extracted one by one: cells below a finer level that are not blanked,
 * and faces between two levels that an isovalue crosses, where surfaces have gaps.
 *
 * @sa vtkIsotableContour vtkIsotable
 */
class INTERLUMEINTERVALS_EXPORT vtkIntervalVolume : public vtkIntervalAlgorithm
{
public:
  static vtkIntervalVolume* New();
  vtkTypeMacro(vtkIntervalVolume, vtkIntervalAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum BoundarySides
  {
    LOWER_SIDE = 0,
    UPPER_SIDE = 1
  };

  ///@{
  /**
   * Further criteria: the result is also cut to lower <= array <= upper of another point array, one
   * pass of the same algorithm over the tetrahedra for each, which keeps their orientation: parts
   * of inverted tetrahedra are inverted, so that signed volumes add up. The array is named, has one
   * component, and is found in the input's point data. Default none. Of a criterion that is not
   * there the name is null, and the range leaves its arguments. AddCriterionAsText takes the bounds
   * as they are typed; a word that is no number is named in the error of the next execution, and
   * the range has NaN in its place.
   */
  void AddCriterion(const char* arrayName, double lower, double upper);
  void AddCriterionAsText(const char* arrayName, const char* lower, const char* upper);
  void RemoveAllCriteria();
  int GetNumberOfCriteria() const { return static_cast<int>(this->Criteria.size()); }
  const char* GetCriterionArrayName(int i) const;
  void GetCriterionRange(int i, double& lower, double& upper) const;
  ///@}

  ///@{
  /**
   * Whether port 1 carries the boundary triangles. With criteria, the triangles where a criterion's
   * array equals its bound are not among them. Default off.
   */
  vtkSetMacro(GenerateBoundaries, bool);
  vtkGetMacro(GenerateBoundaries, bool);
  vtkBooleanMacro(GenerateBoundaries, bool);
  ///@}

  ///@{
  /**
   * Whether cells that are wholly inside an interval and all criteria are passed on as they are,
   * and only cells that are cut become tetrahedra; see above. Default off.
   */
  vtkSetMacro(KeepWholeCells, bool);
  vtkGetMacro(KeepWholeCells, bool);
  vtkBooleanMacro(KeepWholeCells, bool);
  ///@}

  ///@{
  /**
   * Whether the outputs carry arrays that tell where they come from: point arrays `OriginPoints`
   * (vtkIdType, 2 components: the input's points whose edge an output point lies on, twice the same
   * for one of the input's points) and `OriginWeight` (double, 0 to 1/2: how far from the first to
   * the second), cell array `OriginCell` (vtkIdType, on both ports). Polyhedra that are coned have
   * an apex each, with ids from the number of the input's points on. With criteria this has no
   * effect. Default off.
   */
  vtkSetMacro(KeepOrigins, bool);
  vtkGetMacro(KeepOrigins, bool);
  vtkBooleanMacro(KeepOrigins, bool);
  ///@}

  ///@{
  /**
   * Whether an index of value ranges is kept between executions, so that changed intervals visit
   * only the cells near them. It is built when the intervals change for the first time over the
   * same input. Default on.
   */
  vtkSetMacro(UseValueIndex, bool);
  vtkGetMacro(UseValueIndex, bool);
  vtkBooleanMacro(UseValueIndex, bool);
  ///@}

  ///@{
  /**
   * Whether large blocks of memory that nobody holds any more, those of outputs let go of and
   * working memory, are kept for the next execution, for intervals that are dragged: clearing new
   * pages is a tenth to a half of the time of an update. The result is the same to the last byte.
   * An output that others hold stays theirs; what they let go of comes back. Blocks that two
   * executions in a row have not used are freed, and all where this is off in an execution, or the
   * filter is deleted: in between at most about one output more is held. Default off.
   */
  vtkSetMacro(KeepMemory, bool);
  vtkGetMacro(KeepMemory, bool);
  vtkBooleanMacro(KeepMemory, bool);
  ///@}

  /**
   * Returns the report of the last execution:
   * - Cells, CellsWithOutput: cells of the input, and those of them that give a simplex
   * - BlankedCells: cells skipped because they or a point are blanked, hidden or a ghost
   * - NonFiniteCells: cells skipped because a value or a coordinate is NaN or infinite
   * - LowerDimensionalCells, UnsupportedCells: cells skipped because of their type
   * - LinearizedCells: quadratic and higher cells treated as linear
   * - ConcavePolyhedra: polyhedra whose parts overlap
   * - FoldedCells: cells with output that cross themselves
   * - NonPlanarFaces: quadrilaterals where KeepWholeCells may leave a gap or an overlap
   */
  vtkInterlumeReport* GetReport() { return this->Report; }

protected:
  vtkIntervalVolume();
  ~vtkIntervalVolume() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkIntervalVolume(const vtkIntervalVolume&) = delete;
  void operator=(const vtkIntervalVolume&) = delete;

  struct Criterion
  {
    std::string ArrayName;
    double Lower;
    double Upper;
    /// A bound that is not a number, as it was typed.
    std::string InvalidBound;
  };

  /// Returns an error if the intervals or criteria cannot be used.
  interlume::Error CheckParameters(vtkDataSet* input) const;
  /// Extracts from one dataset.
  void ExtractFrom(vtkDataSet* input, interlume::ExtractionRun& run, vtkUnstructuredGrid* output,
    vtkUnstructuredGrid* boundary);
  /// Runs the first pass; \a whole is null where cells are not kept whole. Returns false when the
  /// user aborted.
  bool ExtractIntervals(vtkDataSet* input, vtkDataArray* scalars, interlume::ExtractionRun& run,
    interlume::WholePass* whole, vtkUnstructuredGrid* output, vtkUnstructuredGrid* boundary);
  /// Runs a further pass, over the result of the one before.
  bool ApplyCriterion(int number, interlume::ExtractionRun& run, interlume::WholePass* whole,
    vtkUnstructuredGrid* grid, vtkUnstructuredGrid* boundary);

  ///@{
  /// Begins and ends what memory is kept in an execution.
  void BeginMemory();
  void EndMemory(interlume::ExtractionReport& report);
  ///@}

  std::vector<Criterion> Criteria;
  bool GenerateBoundaries = false;
  bool KeepWholeCells = false;
  bool KeepOrigins = false;
  bool UseValueIndex = true;
  bool KeepMemory = false;
  vtkNew<vtkInterlumeReport> Report;
  vtkSmartPointer<interlume::ExtractionIndex> Index;
  /// Null where no memory is kept.
  std::unique_ptr<interlume::KeptMemory> Memory;
};

#endif
