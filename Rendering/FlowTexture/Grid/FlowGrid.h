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
 * @brief   an implicit flow field as voxels and cells for interpolation in a shader
 *
 * Each voxel has a label: 0 if its streamline reached no surface, otherwise the position of the
 * surface's id in Ids, starting at 1. Each cell between eight voxels has a kind, which determines
 * the interpolation:
 * - a label: all corners have this label, without a seam or a time discontinuity in the cell;
 * - SEAM plus a label: all corners have this label and lie on both sides of a seam;
 * - SPLIT: the corners have several labels;
 * - SPLIT_BY_SIDES: streamlines return to a surface that passes through the cell. Corners with the
 *   same label then form two groups with different times and coordinates (vtkFlowStatus::AWAY);
 * - EMPTY plus a distance: no corner has a label, and all cells at a smaller distance (in the
 *   maximum norm) are empty too.
 */
class FlowGrid
{
public:
  enum Kinds : unsigned short
  {
    SPLIT = 0,
    LARGEST_LABEL = 4094,
    SPLIT_BY_SIDES = 4095,
    SEAM = 4096,
    EMPTY = 8192
  };
  /// A value in Groups is a label times NumberOfSides, plus the side: 1 or 2 for an AWAY voxel,
  /// otherwise 0.
  static constexpr int NumberOfSides = 3;

  /// Periodicity of u and v.
  using Periodicity = std::array<bool, 2>;

  /**
   * Reads the arrays of vtkImplicitFlowField. Returns an error if they are not valid. Samples whose
   * coordinates or time are not finite are treated as not having reached a surface.
   */
  Error Build(vtkImageData* image);

  /// Returns the label of an id, or 0 if no sample has the id.
  int FindLabel(int id) const;

  std::array<int, 3> Size{};
  /// Sorted ids of the reached surfaces, and their periodicity.
  std::vector<int> Ids;
  std::vector<Periodicity> Periods;
  /// u and v per voxel, with any integer number of periods added, or 0 if there is no label.
  std::vector<float> Parameters;
  /// Advection time per voxel, or 0 if there is no label.
  std::vector<float> Times;
  /// Two values per cell: its kind, and a code for an upper bound of the slopes of u and v, see
  /// GetSlopeCode. The code is odd if the cell and all its neighbors have the same label as their
  /// kind. Along each axis, there is one cell fewer than there are voxels.
  std::vector<unsigned short> Cells;
  /// Returns the smallest even code for a slope (the length of a gradient in voxel coordinates). A
  /// code represents slopes up to 2^(code / 256 - 128); codes 0 and 1 represent 0.
  static unsigned short GetSlopeCode(float slope);
  /// For each voxel, its label times NumberOfSides plus its side; empty if no cell is split.
  std::vector<unsigned short> Groups;
  vtkIdType UniformCells = 0;
  vtkIdType SeamCells = 0;
  vtkIdType SplitCells = 0;
  vtkIdType EmptyCells = 0;
  /// Ids of samples that reached a surface and whose coordinates or time are not finite.
  std::vector<vtkIdType> NonFinite;

private:
  struct Arrays;

  void FindIds(const Arrays& arrays);
  void ReadPeriodicity(vtkImageData* image);
  void ReadVoxels(const Arrays& arrays);
  /// Calls visit(i, j, k, cell) for all cells in parallel. \a cell is the index of the cell's
  /// kind in Cells.
  template <typename Visit>
  void ForEachCell(const Visit& visit) const;
  void FindKinds();
  unsigned short FindKind(const std::array<vtkIdType, 8>& corners) const;
  float FindSlope(const std::array<vtkIdType, 8>& corners) const;
  void FindDistances();
  void MarkInnerCells();
};

}

#endif
