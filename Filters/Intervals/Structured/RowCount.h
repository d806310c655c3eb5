// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_RowCount_h
#define interlume_RowCount_h

#include "vtkType.h"

namespace interlume
{

/**
 * The counts of a row: points owned, simplices, boundary triangles and interior cells; after
 * summing, the places where those of the row begin.
 */
struct RowCount
{
  vtkIdType Points = 0;
  vtkIdType Simplices = 0;
  vtkIdType Triangles = 0;
  vtkIdType Interior = 0;

  void Add(const RowCount& other)
  {
    this->Points += other.Points;
    this->Simplices += other.Simplices;
    this->Triangles += other.Triangles;
    this->Interior += other.Interior;
  }

  /// Returns whether cells of a row that begins here have output, where the next begins at \a next.
  bool HasCells(const RowCount& next) const
  {
    return this->Simplices != next.Simplices || this->Triangles != next.Triangles ||
      this->Interior != next.Interior;
  }
};

}

#endif
