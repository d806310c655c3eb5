// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkSceneDepth_h
#define vtkSceneDepth_h

#include "InterlumeSceneModule.h" // for the export macro

#include <array>  // for sizes
#include <vector> // for depths

class vtkRenderer;
class vtkTextureObject;

/**
 * @class   vtkSceneDepth
 * @brief   the depth of what is already in the picture
 *
 * The depth is that of the renderer's viewport in the framebuffer that is being drawn to, with one
 * sample a pixel or more: 0 at the near plane to 1 at the far one.
 */
class INTERLUMESCENE_EXPORT vtkSceneDepth
{
public:
  /**
   * Reads the depth row by row from below; \a size gets columns and rows. Returns false where it
   * could not be read.
   */
  static bool Read(vtkRenderer* renderer, std::vector<float>& depths, std::array<int, 2>& size);

  /**
   * Copies the depth to a texture of floats, which is made as large as the viewport. Returns false
   * where there is none.
   */
  static bool CopyTo(vtkRenderer* renderer, vtkTextureObject* texture);
};

#endif
