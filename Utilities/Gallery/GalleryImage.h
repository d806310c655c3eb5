// SPDX-License-Identifier: BSD-3-Clause
#ifndef GalleryImage_h
#define GalleryImage_h

#include "vtkImageData.h"
#include "vtkRenderWindow.h"
#include "vtkSmartPointer.h"

/**
 * Functions for images in memory. Images are RGB, unsigned char, with the lower left pixel first.
 */
namespace gallery
{
/**
 * Creates an off-screen window without multisampling.
 */
vtkSmartPointer<vtkRenderWindow> MakeWindow(int width, int height);

/**
 * Keeps a connection to the display open. A virtual X server resets when its last client
 * disconnects, and no window can be opened during the reset. Programs that open several windows one
 * after another should first create a DisplayKeepAlive.
 */
class DisplayKeepAlive
{
public:
  DisplayKeepAlive();

private:
  vtkSmartPointer<vtkRenderWindow> Window;
};

/**
 * Renders the window and returns its image.
 */
vtkSmartPointer<vtkImageData> GrabImage(vtkRenderWindow* window);

/**
 * Copies \a part into \a whole. The lower left pixel of \a part is placed at (left, bottom).
 * \a part must fit into \a whole.
 */
void Paste(vtkImageData* whole, vtkImageData* part, int left, int bottom);

/**
 * Returns \a large reduced by \a factor along each axis. Each pixel is the mean of factor x factor
 * pixels.
 */
vtkSmartPointer<vtkImageData> DownsampleRgbImage(vtkImageData* large, int factor);
}

#endif
