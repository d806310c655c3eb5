// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FieldVectors_h
#define interlume_FieldVectors_h

#include <string>

class vtkDataArray;
class vtkDataSet;
class vtkInformation;

namespace interlume
{

/**
 * @class   FieldVectors
 * @brief   the vectors and cells of a flow filter's field, and what is wrong with them
 */
class FieldVectors
{
public:
  /// Sets the types of datasets that are taken.
  static void FillPortInformation(vtkInformation* info);

  /**
   * Returns what is wrong with the array to process, null where there is none, or with the cells;
   * nothing for vectors of three components in the points, and cells of MultilinearCell's types;
   * those that are left out may be others. \a asked says which array it should be.
   */
  static std::string Check(
    vtkDataSet* data, vtkDataArray* vectors, int association, vtkInformation* asked);

  /// Returns what is wrong with the array alone.
  static std::string CheckVectors(
    vtkDataSet* data, vtkDataArray* vectors, int association, vtkInformation* asked);

  /// Returns why two arrays of blocks cannot be one, by their names; nothing if they can.
  static std::string CompareNames(vtkDataArray* first, vtkDataArray* other);

private:
  static std::string CheckCells(vtkDataSet* data);
};

}

#endif
