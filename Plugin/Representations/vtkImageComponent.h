// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkImageComponent_h
#define vtkImageComponent_h

#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <array>

class vtkDataArray;
class vtkImageData;
class vtkTrivialProducer;

/**
 * @class   vtkImageComponent
 * @brief   extracts one component of an image array, or its magnitude
 *
 * In ParaView, this component or magnitude determines the color of an array with several
 * components. The image is recomputed when the array or the component changes.
 */
class vtkImageComponent
{
public:
  vtkImageComponent();
  ~vtkImageComponent();

  /**
   * Returns a producer of an image with the geometry of \a image and one array, which has the name
   * of \a array. Its values are the component, or the magnitude if \a component is negative, as
   * float, or double if \a array is double. It is a point array if \a isOfPoints, otherwise a cell
   * array.
   */
  vtkTrivialProducer* Update(
    vtkImageData* image, vtkDataArray* array, bool isOfPoints, int component);

private:
  /// Arguments of the last Update.
  struct Key
  {
    vtkDataArray* Array = nullptr;
    vtkMTimeType Time = 0;
    vtkMTimeType ImageTime = 0;
    bool IsOfPoints = true;
    int Component = 0;
    bool operator==(const Key& other) const;
  };
  Key LastKey;
  vtkNew<vtkTrivialProducer> Producer;
};

#endif
