// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FlowGrid_h
#define interlume_FlowGrid_h

#include "Common/Error.h"

#include "vtkType.h"

#include <array>
#include <vector>

class vtkDataArray;
class vtkImageData;

namespace interlume
{

/**
 * @class   FlowGrid
 * @brief   an implicit flow field as voxels that a shader can interpolate in
 *
 * Each voxel has a label: 0 where its streamline reached no surface, and else the place of its
 * surface's id in Ids, from 1. Each cell between eight voxels has a kind, which tells how to
 * interpolate in it:
 * - a label: all corners have it, and neither a seam nor a surface that times jump at is between
 *   them;
 * - SEAM plus a label: all corners have it, and lie on both sides of a seam;
 * - SPLIT: the corners have several labels;
 * - SPLIT_BY_WAYS: a surface passes through the cell that streamlines come round to again, so that
 *   corners of one label have times, and places, of two kinds (vtkFlowStatus::AWAY);
 * - EMPTY plus a distance: no corner has a label, and so have none within fewer than that many
 *   cells along any axis.
 */
class FlowGrid
{
public:
  enum Kinds : unsigned short
  {
    SPLIT = 0,
    LARGEST_LABEL = 4094,
    SPLIT_BY_WAYS = 4095,
    SEAM = 4096,
    EMPTY = 8192
  };
  /// Labels in Groups are multiplied by this; the rest is 0, or the side of a voxel of AWAY.
  static constexpr int Ways = 3;

  /// The ids' periodic directions.
  using Periodicity = std::array<bool, 2>;

  /**
   * Reads the arrays that vtkImplicitFlowField writes. Returns an error if they cannot be used.
   * Samples that reached a surface with a position or a time that is not finite count as having
   * reached none.
   */
  Error Build(vtkImageData* image);

  /// Returns the label of an id; 0 where no sample has it.
  int FindLabel(int id) const;

  std::array<int, 3> Size{};
  /// The ids in use, in order, and whether u and v are periodic there.
  std::vector<int> Ids;
  std::vector<Periodicity> Periods;
  /// u and v of each voxel, with any number of periods more or less; 0 without a label.
  std::vector<float> Places;
  /// The advection time of each voxel, 0 without a label.
  std::vector<float> Times;
  /// The kinds of cells, each with the code of a bound of the slopes of u and v within it; one cell
  /// fewer than voxels along each axis. The codes of cells that all cells around are like, labels
  /// of one surface, are odd.
  std::vector<unsigned short> Cells;
  /// A slope, the length of a gradient by voxels, is at most 2^(code / 256 - 128), and 0 for the
  /// codes 0 and 1. Returns the least even code.
  static unsigned short GetSlopeCode(float slope);
  /// For each voxel its label times Ways, and its way; empty where no cell is split.
  std::vector<unsigned short> Groups;
  vtkIdType UniformCells = 0;
  vtkIdType SeamCells = 0;
  vtkIdType SplitCells = 0;
  vtkIdType EmptyCells = 0;
  /// The number of samples that reached a surface at no finite place or time.
  vtkIdType NonFinite = 0;

private:
  struct Arrays;

  void FindIds(const Arrays& arrays);
  void ReadPeriods(vtkImageData* image);
  void ReadVoxels(const Arrays& arrays);
  /// Calls visit(i, j, k, cell) for all cells in parallel, with their numbers in Cells.
  template <typename Visit>
  void ForEachCell(const Visit& visit) const;
  void FindKinds();
  unsigned short FindKind(const std::array<vtkIdType, 8>& corners) const;
  float FindSlope(const std::array<vtkIdType, 8>& corners) const;
  void FindDistances();
  void MarkInner();
};

}

#endif
