// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkTextureImage_h
#define vtkTextureImage_h

class vtkImageData;
class vtkTexture;

/**
 * Returns the image of a texture that was selected in ParaView. Reads it again if its file has
 * changed. Returns null if the texture is null.
 */
vtkImageData* vtkTextureImage(vtkTexture* texture);

#endif
