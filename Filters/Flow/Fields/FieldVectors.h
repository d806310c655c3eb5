// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FieldVectors_h
#define interlume_FieldVectors_h

#include "Common/CellArrayConversion.h"
#include "Common/Error.h"

class vtkAbstractArray;
class vtkDataSet;
class vtkAlgorithm;
class vtkInformation;
class vtkInformationVector;

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

  /// Selects the vectors of the dataset in \a inputs. Reports an error for \a owner if Check()
  /// fails or the dataset has points but no cells. Returns no dataset then, and if the dataset is
  /// empty.
  static CellArrayConversion::Selection Select(vtkAlgorithm* owner, CellArrayConversion& conversion,
    vtkInformationVector** inputs, vtkInformationVector* outputs);

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
