// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureImage.h"

#include "vtkAlgorithm.h"
#include "vtkImageData.h"
#include "vtkTexture.h"

vtkImageData* vtkTextureImage(vtkTexture* texture)
{
  if (texture && texture->GetInputAlgorithm())
  {
    texture->GetInputAlgorithm()->Update();
  }
  return texture ? texture->GetInput() : nullptr;
}
