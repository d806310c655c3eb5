// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ImageSample_h
#define interlume_ImageSample_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

class vtkDataArray;
class vtkImageData;

namespace interlume
{

/**
 * @class   ImageSample
 * @brief   selects every n-th point of an image along each axis, for a first frame before the data
 * of the image are prepared
 */
class ImageSample
{
public:
  /// Maximum number of points of a sample. Images with at most 8 times as many points need none.
  static constexpr vtkIdType SIZE = 200000;

  /// Selects points of \a image if the image or \a scalars, a point array, has changed.
  void Update(vtkImageData* image, vtkDataArray* scalars);

  /// Returns the sample, whose scalars are the selected values.
  vtkImageData* GetImage() const { return this->Image; }
  /// Returns the number of points of the image per point of the sample, along each axis.
  int GetStride() const { return this->Stride; }

private:
  vtkSmartPointer<vtkImageData> Image;
  int Stride = 1;
  /// Input of the last update.
  vtkImageData* Input = nullptr;
  vtkDataArray* InputScalars = nullptr;
  vtkMTimeType InputTime = 0;
};

}

#endif
