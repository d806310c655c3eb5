// SPDX-License-Identifier: BSD-3-Clause
#ifndef DrawingAborts_h
#define DrawingAborts_h

class vtkRenderWindow;

namespace reference
{

class Check;

/**
 * Checks that a mapper stops rendering when the window's vtkCommand::AbortCheckEvent requests an
 * abort. Frames rendered afterward, from the same and from another view, must be bit-identical to
 * frames rendered without aborts. The window must show a volume. VTK invokes the event at most five
 * times a second.
 */
void CheckDrawingAborts(vtkRenderWindow* window, Check& check);

}

#endif
