// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FieldVectors_h
#define interlume_FieldVectors_h

#include "Common/Error.h"

class vtkDataArray;
class vtkDataSet;
class vtkInformation;

namespace interlume
{

/**
 * @class   FieldVectors
 * @brief   checks the vectors and cells of a flow filter's field
 */
class FieldVectors
{
public:
  /// Sets the types of datasets that are taken.
  static void FillPortInformation(vtkInformation* info);

  /**
   * Returns an error unless the array to process, null without one, has three components in the
   * points, and the cells are of MultilinearCell's types; cells that are left out may be others.
   * \a asked says which array it should be.
   */
  static Error Check(
    vtkDataSet* data, vtkDataArray* vectors, int association, vtkInformation* asked);

  /// Checks only the array.
  static Error CheckVectors(
    vtkDataSet* data, vtkDataArray* vectors, int association, vtkInformation* asked);

  /// Returns an error if two arrays of blocks cannot be one, by their names.
  static Error CompareNames(vtkDataArray* first, vtkDataArray* other);

private:
  static Error CheckCells(vtkDataSet* data);
};

}

#endif
