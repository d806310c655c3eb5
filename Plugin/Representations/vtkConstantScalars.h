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
 * A byte a point. Made anew when the dataset changes.
 */
class vtkConstantScalars
{
public:
  vtkConstantScalars();
  ~vtkConstantScalars();

  /// The name of the array.
  static const char* GetArrayName();

  /// A shallow copy of \a data with the array.
  vtkTrivialProducer* Update(vtkDataSet* data);

private:
  /// What it was made of.
  vtkDataSet* Made = nullptr;
  vtkMTimeType MadeTime = 0;
  vtkNew<vtkTrivialProducer> Producer;
};

#endif
