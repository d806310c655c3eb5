// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkTextureImage_h
#define vtkTextureImage_h

class vtkImageData;
class vtkTexture;

/**
 * The image of a texture that was chosen in ParaView, read anew where its file has changed. Null
 * for null.
 */
vtkImageData* vtkTextureImage(vtkTexture* texture);

#endif
