// SPDX-License-Identifier: BSD-3-Clause
#ifndef DrawingAborts_h
#define DrawingAborts_h

class vtkRenderWindow;

namespace reference
{

class Check;

/**
 * The window shows a volume, and asks while it is drawn: VTK does, five times a second at most. A
 * mapper that the window's vtkCommand::AbortCheckEvent stops leaves off, and leaves no trace: drawn
 * without an abort afterwards, from there and from another view, are the bytes of pictures that
 * were never stopped.
 */
void CheckDrawingAborts(vtkRenderWindow* window, Check& check);

}

#endif
