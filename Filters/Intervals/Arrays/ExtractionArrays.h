// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ExtractionArrays_h
#define interlume_ExtractionArrays_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstddef>

class vtkAbstractArray;
class vtkCellData;
class vtkDataSet;
class vtkDataSetAttributes;
class vtkPointData;

namespace interlume
{

/**
 * @class   ExtractionArrays
 * @brief   selects the arrays of output points and cells, and the types of these arrays
 *
 * Numeric point arrays are interpolated along grid edges. The result is float for float and for
 * 8-bit and 16-bit integers, otherwise double. Other point arrays use the value of the closer end
 * of the edge. Global ids, pedigree ids and ghost arrays are dropped. Cell arrays keep their type.
 */
class ExtractionArrays
{
public:
  /// Returns the type of output coordinates, VTK_FLOAT or VTK_DOUBLE, for a value of
  /// vtkAlgorithm::DesiredOutputPrecision.
  static int ChoosePointType(vtkDataSet* input, int precision);

  ///@{
  /// Return the size in bytes of an output point, with its coordinates and arrays, and of the
  /// arrays of an output cell.
  static std::size_t GetBytesPerPoint(vtkDataSet* input, int precision);
  static std::size_t GetBytesPerCell(vtkDataSet* input);
  ///@}

  /// Copies the cell arrays. \a cells contains the input cell of each of \a number output cells.
  /// Returns the number of copied arrays.
  static int CopyCellData(
    vtkCellData* input, const vtkIdType* cells, vtkIdType number, vtkCellData* output);

  /// Gets the number of points per axis of image data, a rectilinear grid or a structured grid.
  /// Returns false for other datasets.
  static bool GetRowDimensions(vtkDataSet* input, int dimensions[3]);

  /// Returns whether an array of \a attributes is passed to the output.
  static bool IsCarried(vtkDataSetAttributes* attributes, vtkAbstractArray* array);

  /// Returns whether two arrays are compatible for interpolation between them. Either may be null.
  static bool AreCompatible(vtkAbstractArray* a, vtkAbstractArray* b);

  /// Adds \a out to \a output, with the name and the component names of \a in. If \a in is an
  /// active attribute of \a input, such as the scalars, \a out becomes the same attribute of \a
  /// output.
  static void AddArrayLike(vtkDataSetAttributes* input, vtkAbstractArray* in,
    vtkDataSetAttributes* output, vtkAbstractArray* out);

  /// Makes the processed array the active scalars, for color mapping. An unnamed array (name null
  /// or empty) is already the active scalars, since it could not have been selected otherwise.
  static void ActivateScalars(const char* name, vtkPointData* output);

  /// Creates an empty array for interpolated values of \a in.
  static vtkSmartPointer<vtkAbstractArray> NewInterpolatedArray(vtkAbstractArray* in);

  /// Returns the data type of interpolated values of an array of type \a dataType.
  static int GetInterpolatedType(int dataType);
};

}

#endif
