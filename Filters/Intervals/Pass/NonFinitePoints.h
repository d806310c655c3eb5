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
 * @brief   marks the points of a grid that have a NaN or infinite coordinate
 *
 * Extractions treat the values at these points as NaN and skip their cells.
 */
class NonFinitePoints
{
public:
  /// Marks no points.
  NonFinitePoints() = default;
  explicit NonFinitePoints(vtkDataSet* grid);

  /// Returns a mark for each point, or null if all coordinates are finite.
  const unsigned char* GetMarks() const
  {
    return this->Marks.empty() ? nullptr : this->Marks.data();
  }

  /// Returns a warning that counts the cells that these points take from an extraction and names
  /// the first one, or an empty string if there is none. \a grid may be the grid before polyhedra
  /// were cut. Cells of 4-simplices count if \a hasSimplices is true.
  std::string Describe(vtkDataSet* grid, bool hasSimplices = false) const;

private:
  std::vector<unsigned char> Marks;
};

}

#endif
