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
 * @brief   checks the vectors and cells of the input field of a flow filter
 */
class FieldVectors
{
public:
  /// Sets the supported dataset types.
  static void FillPortInformation(vtkInformation* info);

  /**
   * Returns an error unless the array to process is a point array with three components, and
   * MultilinearCell supports the cell types. Blanked and flat cells may have other types, but not
   * all cells may be flat. \a vectors may be null; \a request describes the requested array.
   */
  static Error Check(
    vtkDataSet* data, vtkDataArray* vectors, int association, vtkInformation* request);

  /// Checks only the array.
  static Error CheckVectors(
    vtkDataSet* data, vtkDataArray* vectors, int association, vtkInformation* request);

  /// Returns an error if the vectors of two blocks have different names.
  static Error CompareNames(vtkDataArray* first, vtkDataArray* other);

private:
  static Error CheckCells(vtkDataSet* data);
};

}

#endif
