// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_CellZeros_h
#define interlume_CellZeros_h

#include "Cells/MultilinearCell.h"

#include <vector>

namespace interlume
{

/**
 * @class   CellZeros
 * @brief   all zeros of a trilinear function of three components in a cell
 *
 * The cell's cube is split in halves of each direction until what is left of each box is clear:
 * - a component has one sign at all corners, which bound it on the box: no zero. The same holds for
 *   the
 *   components times the inverse of the Jacobian in the middle, which are about the distance from a
 *   zero.
 * - the derivatives of those, which the differences along the box's edges bound, differ by less
 *   than 1/2 from the identity's: at most one zero. Newton's method, with that inverse and held in
 *   the box, is a contraction and finds it.
 *
 * Boxes that are not clear at a 2^-24th of the cell's size hold a zero with a singular Jacobian. If
 * there are more and more of them the zeros are not isolated: lines or surfaces.
 *
 * Each thread has its own.
 */
class CellZeros
{
public:
  struct Zero
  {
    double Parameters[3];
    /// The uncertainty of the zero, in parameters.
    double Tolerance;
    /// Whether the Jacobian is singular at the zero.
    bool IsDegenerate;
  };

  /// Finds the zeros, also those outside of the cell by no more than roundings. Returns false, and
  /// none, where they are not isolated.
  bool Find(
    MultilinearCell::Shapes shape, const MultilinearCell::Values& values, std::vector<Zero>& zeros);

private:
  struct Box
  {
    double Lower[3];
  };

  enum Findings
  {
    CLEAR,
    SPLIT
  };

  /// Returns whether the values at the corners alone tell that there is no zero, or that zeros are
  /// not isolated.
  bool Settle(const MultilinearCell::Values& values, bool& isIsolated) const;
  bool HasZeroEdge(const MultilinearCell::Values& values) const;
  Findings Examine(const Box& box, double size, std::vector<Zero>& zeros) const;
  void Solve(const Box& box, double size, const MultilinearCell::Values& scaled,
    std::vector<Zero>& zeros) const;
  void AddDegenerate(double size, std::vector<Zero>& zeros) const;
  static void Add(const Zero& zero, std::vector<Zero>& zeros);

  MultilinearCell::Shapes Shape = MultilinearCell::BOX;
  /// The values, scaled so that each component's largest absolute value is 1.
  MultilinearCell::Values Normalized = {};
  std::vector<Box> Boxes;
  std::vector<Box> Parts;
};

}

#endif
