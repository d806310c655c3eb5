// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_CarriedArrays_h
#define interlume_CarriedArrays_h

#include "vtkSmartPointer.h"

#include <vector>

class vtkAbstractArray;
class vtkDataSet;
class vtkPointData;
class vtkPoints;

namespace interlume
{

/**
 * @class   CarriedArrays
 * @brief   the coordinates and point arrays that an output of a dataset has, to be given values
 */
class CarriedArrays
{
public:
  /// An array of the input and what it becomes.
  struct Carried
  {
    vtkAbstractArray* In;
    vtkSmartPointer<vtkAbstractArray> Out;
  };

  /// Makes them without values; \a precision is one of vtkAlgorithm.
  CarriedArrays(vtkDataSet* input, int precision);

  const vtkSmartPointer<vtkPoints>& GetPoints() const { return this->Points; }
  const std::vector<Carried>& GetArrays() const { return this->Arrays; }
  /// Returns whether there are arrays that are not of numbers: they take the value of the nearer
  /// end.
  bool HasOthers() const { return this->Others; }

  /// Gives the arrays to \a output.
  void AddTo(vtkPointData* output) const;

private:
  vtkDataSet* Input;
  vtkSmartPointer<vtkPoints> Points;
  std::vector<Carried> Arrays;
  bool Others = false;
};

}

#endif
