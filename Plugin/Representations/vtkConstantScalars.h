// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkConstantScalars_h
#define vtkConstantScalars_h

#include "vtkNew.h"
#include "vtkType.h"

class vtkDataSet;
class vtkTrivialProducer;

/**
 * @class   vtkConstantScalars
 * @brief   adds a point array of zeros to a dataset, for mappers that draw scalars
 *
 * The array takes a byte a point, and is made anew when the dataset changes.
 */
class vtkConstantScalars
{
public:
  vtkConstantScalars();
  ~vtkConstantScalars();

  /// Returns the name of the array.
  static const char* GetArrayName();

  /// Returns a shallow copy of \a data with the array.
  vtkTrivialProducer* Update(vtkDataSet* data);

private:
  /// The dataset that the copy was made of.
  vtkDataSet* Made = nullptr;
  vtkMTimeType MadeTime = 0;
  vtkNew<vtkTrivialProducer> Producer;
};

#endif
