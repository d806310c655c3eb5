// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkTextureImage_h
#define vtkTextureImage_h

class vtkImageData;
class vtkTexture;

/**
 * Returns the image of a texture that was selected in ParaView, after updating its reader, or null
 * if the texture is null.
 */
vtkImageData* vtkTextureImage(vtkTexture* texture);

#endif
