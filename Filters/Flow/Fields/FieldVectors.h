// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FieldVectors_h
#define interlume_FieldVectors_h

#include "Common/CellArrayConversion.h"
#include "Common/Error.h"

class vtkAbstractArray;
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
   * Returns an error unless the selected array is a point array with three components, and
   * MultilinearCell supports the cell types. Blanked and flat cells may have other types, but not
   * all cells may be flat. The array may be null; \a request describes the requested array.
   */
  static Error Check(const CellArrayConversion::Selection& selection, vtkInformation* request);

  /// Checks only the array.
  static Error CheckVectors(
    const CellArrayConversion::Selection& selection, vtkInformation* request);

  /// Returns an error if the vectors of two blocks have different names.
  static Error CompareNames(vtkAbstractArray* first, vtkAbstractArray* other);

private:
  static Error CheckCells(vtkDataSet* data);
};

}

#endif
