// SPDX-License-Identifier: BSD-3-Clause
#ifndef Picture_h
#define Picture_h

#include "vtkImageData.h"
#include "vtkRenderWindow.h"
#include "vtkSmartPointer.h"

/**
 * Pictures as pixels: RGB, unsigned char, lower left first.
 */
namespace gallery
{
/**
 * An off-screen window without multisampling.
 */
vtkSmartPointer<vtkRenderWindow> MakeWindow(int width, int height);

/**
 * Holds the display for as long as it lives. A virtual X server starts anew when its last client
 * leaves, and refuses a window that is opened meanwhile; a program that draws several windows one
 * after the other holds one of these.
 */
class DisplayHold
{
public:
  DisplayHold();

private:
  vtkSmartPointer<vtkRenderWindow> Window;
};

/**
 * Draws the window and reads it.
 */
vtkSmartPointer<vtkImageData> GrabPicture(vtkRenderWindow* window);

/**
 * Copies \a part into \a whole with its lower left pixel at (left, bottom); it has to fit.
 */
void Paste(vtkImageData* whole, vtkImageData* part, int left, int bottom);

/**
 * The picture of 1/factor of the size, each pixel the mean of factor x factor.
 */
vtkSmartPointer<vtkImageData> AverageDown(vtkImageData* large, int factor);
}

#endif
