// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_NonFinitePoints_h
#define interlume_NonFinitePoints_h

#include "vtkType.h"

#include <string>
#include <vector>

class vtkDataSet;

namespace interlume
{

/**
 * @class   NonFinitePoints
 * @brief   marks the grid points that have a NaN or infinite coordinate
 *
 * Extractions treat the values at these points as NaN and skip their cells.
 */
class NonFinitePoints
{
public:
  /// Creates an object without marks.
  NonFinitePoints() = default;
  explicit NonFinitePoints(vtkDataSet* grid);

  /// Returns a mark per point, or null if all coordinates are finite.
  const unsigned char* GetMarks() const
  {
    return this->Marks.empty() ? nullptr : this->Marks.data();
  }

  /// Returns a warning with the number of cells that are skipped because of these points, and the
  /// first such cell. Returns an empty string if there are none. \a grid may be the grid before
  /// polyhedra were replaced. \a dimension is the dimension of the cells that are extracted: 2, 3,
  /// or 4 for 4-simplices.
  std::string Describe(vtkDataSet* grid, int dimension = 3) const;

private:
  std::vector<unsigned char> Marks;
};

}

#endif
