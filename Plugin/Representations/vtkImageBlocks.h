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
 * @brief   joins the images of a composite dataset into one image
 *
 * Images are joined if they fill a box without overlap and their samples are on one regular grid.
 * Otherwise, only the image with the most samples is used. The joined image has only those arrays
 * that all images have.
 */
class vtkImageBlocks
{
public:
  /// Joins the images in \a datasets. Skips other datasets and null pointers.
  explicit vtkImageBlocks(const std::vector<vtkDataSet*>& datasets);
  ~vtkImageBlocks();

  /// Returns the image, or null if there is none.
  vtkImageData* GetImage() const { return this->Image; }

  /// Returns the number of datasets that are not part of the image.
  std::size_t GetNumberOfSkippedDatasets() const { return this->Skipped; }

private:
  vtkSmartPointer<vtkImageData> Image;
  std::size_t Skipped = 0;
};

#endif
