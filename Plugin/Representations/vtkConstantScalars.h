// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkConstantScalars_h
#define vtkConstantScalars_h

#include "vtkNew.h"
#include "vtkType.h"

class vtkDataSet;
class vtkTrivialProducer;

/**
 * @class   vtkConstantScalars
 * @brief   adds a point array of zeros to a dataset, for mappers that require scalars
 *
 * The array uses one byte per point. It is recreated when the dataset changes.
 */
class vtkConstantScalars
{
public:
  vtkConstantScalars();
  ~vtkConstantScalars();

  /// Returns the name of the array.
  static const char* GetArrayName();

  /// Returns a producer whose output is a shallow copy of \a data with the array.
  vtkTrivialProducer* Update(vtkDataSet* data);

private:
  /// Dataset that was copied to the producer, and its modification time.
  vtkDataSet* Source = nullptr;
  vtkMTimeType SourceTime = 0;
  vtkNew<vtkTrivialProducer> Producer;
};

#endif
