// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ExtractionArrays_h
#define interlume_ExtractionArrays_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

class vtkAbstractArray;
class vtkCellData;
class vtkDataSet;
class vtkDataSetAttributes;
class vtkPointData;

namespace interlume
{

/**
 * @class   ExtractionArrays
 * @brief   the arrays of output points and cells: which there are, and of what types
 *
 * Numeric point arrays are interpolated along the grid edge and come out as float (from float, and
 * 8 and 16 bit integers) or double; others take the value of the nearer end. Global ids, pedigree
 * ids and ghost arrays are not carried. Cell arrays keep their type.
 */
class ExtractionArrays
{
public:
  /// Returns the type of output points for a precision of vtkAlgorithm: VTK_FLOAT or VTK_DOUBLE.
  static int ChoosePointType(vtkDataSet* input, int precision);

  /// Copies the cell arrays. \a cells has the input cell of each of \a number output cells. Returns
  /// the number of arrays.
  static int CopyCellData(
    vtkCellData* input, const vtkIdType* cells, vtkIdType number, vtkCellData* output);

  /// Gives the points along each axis of a grid of rows. Returns false for other datasets.
  static bool GetRowDimensions(vtkDataSet* input, int dimensions[3]);

  /// Returns whether an array of \a attributes is carried at all.
  static bool IsCarried(vtkDataSetAttributes* attributes, vtkAbstractArray* array);

  /// Returns whether two arrays can be interpolated between; either may be null.
  static bool IsAlike(vtkAbstractArray* a, vtkAbstractArray* b);

  /// Adds \a out with the name, component names and attribute roles that \a in has in \a input.
  static void AddLike(vtkDataSetAttributes* input, vtkAbstractArray* in,
    vtkDataSetAttributes* output, vtkAbstractArray* out);

  /// Makes the array that was processed the active scalars, so that pictures are coloured by it. An
  /// array without a name (null or empty) has the role already: else it could not have been chosen.
  static void ActivateScalars(const char* name, vtkPointData* output);

  /// Creates the array that \a in is interpolated in, without values.
  static vtkSmartPointer<vtkAbstractArray> NewInterpolated(vtkAbstractArray* in);

  /// Returns the data type that an array of \a dataType is interpolated in.
  static int GetInterpolatedType(int dataType);
};

}

#endif
