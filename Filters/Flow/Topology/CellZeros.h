// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_CellZeros_h
#define interlume_CellZeros_h

#include "Cells/MultilinearCell.h"

#include <vector>

namespace interlume
{

/**
 * @class   CellZeros
 * @brief   finds all zeros of a three-component trilinear function in a cell
 *
 * The parameter cube of the cell is bisected along all axes until each box is resolved. A box is
 * resolved in two cases:
 * - A component has the same sign at all corners of the box. The corner values bound the component,
 *   so there is no zero. The test is repeated after the components are multiplied by the inverse
 *   Jacobian at the center of the box. The products approximate the offset from a zero.
 * - The derivatives of these products differ from the identity by less than 1/2, so there is at
 *   most one zero. The differences along the edges of the box bound the derivatives. Newton's
 *   method with the fixed inverse, restricted to the box, is a contraction and finds the zero.
 *
 * A box that is unresolved at 2^-24 of the cell's size contains a zero with a singular Jacobian. If
 * the number of such boxes keeps growing, the zeros form lines or surfaces and are not isolated.
 *
 * Each thread needs its own object.
 */
class CellZeros
{
public:
  struct Zero
  {
    double Parameters[3];
    /// Uncertainty of the zero, in parametric coordinates.
    double Tolerance;
    /// True if the Jacobian is singular at the zero.
    bool IsDegenerate;
  };

  /// Finds the zeros, including zeros that are outside the cell only by rounding error. If the
  /// zeros are not isolated, returns false and no zeros.
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

  /// Returns whether the values at the corners decide the result: there is no zero, or zeros are
  /// not isolated.
  bool DecideByCorners(const MultilinearCell::Values& values, bool& isIsolated) const;
  bool HasZeroEdge(const MultilinearCell::Values& values) const;
  Findings Examine(const Box& box, double size, std::vector<Zero>& zeros) const;
  void Solve(const Box& box, double size, const MultilinearCell::Values& scaled,
    std::vector<Zero>& zeros) const;
  void AddDegenerateZeros(double size, std::vector<Zero>& zeros) const;
  static void Add(const Zero& zero, std::vector<Zero>& zeros);

  MultilinearCell::Shapes Shape = MultilinearCell::BOX;
  /// Values scaled so that the largest absolute value of each component is 1.
  MultilinearCell::Values Normalized = {};
  std::vector<Box> Boxes;
  std::vector<Box> Unresolved;
};

}

#endif
