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
 * @brief   an image with one component of an array, or the array's magnitude
 *
 * ParaView colours by arrays of several components like this. The image is made anew when the array
 * or the choice changes.
 */
class vtkImageComponent
{
public:
  vtkImageComponent();
  ~vtkImageComponent();

  /**
   * Computes the image from \a array of \a image, into floats, or doubles where the array has
   * doubles. \a component below 0 is the magnitude. The result has that array alone, of the same
   * name, at points if \a isOfPoints, else at cells. Threads share the work.
   */
  vtkTrivialProducer* Update(
    vtkImageData* image, vtkDataArray* array, bool isOfPoints, int component);

private:
  /// The arguments that the image was made from.
  struct Key
  {
    vtkDataArray* Array = nullptr;
    vtkMTimeType Time = 0;
    vtkMTimeType ImageTime = 0;
    bool IsOfPoints = true;
    int Component = 0;
    bool operator==(const Key& other) const;
  };
  Key Made;
  vtkNew<vtkTrivialProducer> Producer;
};

#endif
