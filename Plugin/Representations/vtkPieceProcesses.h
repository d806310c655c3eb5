// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkPieceProcesses_h
#define vtkPieceProcesses_h

class vtkMultiProcessController;
class vtkView;

/**
 * @class   vtkPieceProcesses
 * @brief   determines how processes share the rendering of a ParaView view
 */
namespace vtkPieceProcesses
{
/**
 * Returns the controller if each of several processes renders its piece, or null if one process
 * renders everything. Only in the first case do all processes receive REQUEST_RENDER, so that they
 * may communicate during this request. Set \a isReduced if the view renders at a reduced level of
 * detail.
 */
vtkMultiProcessController* Find(vtkView* view, bool isReduced);

/**
 * Returns true if the boxes of all pieces are disjoint, except for common faces, so that the pieces
 * have a visibility order for any view. All processes must call it together. Pass invalid bounds
 * (lower above upper) if this process has no piece.
 */
bool AreDisjoint(vtkMultiProcessController* controller, const double bounds[6]);

/// Returns true if \a isHere is true in any process. All processes must call it together.
bool IsAnywhere(vtkMultiProcessController* controller, bool isHere);

/// Returns true on a tiled display, whose processes render different tiles of the frame, and in a
/// CAVE.
bool HaveDisplays();
}

#endif
