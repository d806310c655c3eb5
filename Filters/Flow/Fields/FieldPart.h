// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FieldPart_h
#define interlume_FieldPart_h

#include "vtkType.h"

class vtkDataSet;

namespace interlume
{

/**
 * @class   FieldPart
 * @brief   the part of a grid that a process holds
 *
 * Each cell of the grid is one process's own. Of grids of rows the parts are extents of the whole
 * grid's points, and Held is what data there are: the own cells with all of their neighbours, of
 * corners too. Of unstructured grids the data are the own cells alone.
 */
struct FieldPart
{
  /// The whole grid without arrays.
  vtkDataSet* Whole = nullptr;
  int WholeExtent[6] = { 0, -1, 0, -1, 0, -1 };
  int Own[6] = { 0, -1, 0, -1, 0, -1 };
  int Held[6] = { 0, -1, 0, -1, 0, -1 };
  /// The numbers of the first own cell of an unstructured grid in the whole, and behind the last.
  vtkIdType FirstCell = 0;
  vtkIdType EndCell = 0;

  /// Returns whether an extent of points has cells of three dimensions.
  static bool HasCells(const int extent[6])
  {
    return extent[0] < extent[1] && extent[2] < extent[3] && extent[4] < extent[5];
  }
};

}

#endif
