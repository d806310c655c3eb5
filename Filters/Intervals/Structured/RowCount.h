// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_RowCount_h
#define interlume_RowCount_h

#include "vtkType.h"

namespace interlume
{

/**
 * Numbers of the points that a row owns and of the simplices, boundary triangles and interior cells
 * of its cells. After summation, these are the positions where the output of the row begins.
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

  /// Returns true if the cells of a row have output. This object and \a next hold the positions of
  /// the row and the next row.
  bool HasCells(const RowCount& next) const
  {
    return this->Simplices != next.Simplices || this->Triangles != next.Triangles ||
      this->Interior != next.Interior;
  }
};

}

#endif
