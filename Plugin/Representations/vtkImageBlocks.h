// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkImageBlocks_h
#define vtkImageBlocks_h

#include "vtkSmartPointer.h"

#include <cstddef>
#include <vector>

class vtkDataSet;
class vtkImageData;

/**
 * @class   vtkImageBlocks
 * @brief   makes one image of those of a composite dataset
 *
 * Images that fill a box together, on one lattice of samples and without overlap, are joined, with
 * the arrays that all of them have. Otherwise the image with the most samples stands for all.
 */
class vtkImageBlocks
{
public:
  /// Joins the images among \a parts; leaves out other datasets, and null.
  explicit vtkImageBlocks(const std::vector<vtkDataSet*>& parts);
  ~vtkImageBlocks();

  /// Returns the image; null without one.
  vtkImageData* GetImage() const { return this->Image; }

  /// Returns how many of the parts are not in the image.
  std::size_t GetNumberLeftOut() const { return this->LeftOut; }

private:
  vtkSmartPointer<vtkImageData> Image;
  std::size_t LeftOut = 0;
};

#endif
