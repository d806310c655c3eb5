// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkPieceProcesses_h
#define vtkPieceProcesses_h

class vtkMultiProcessController;
class vtkView;

/**
 * @class   vtkPieceProcesses
 * @brief   tells which processes draw pieces of what a view of ParaView shows
 */
namespace vtkPieceProcesses
{
/**
 * Returns the controller of the processes that each draw their piece, null where one draws all.
 * Only where all of them draw do all of them come to REQUEST_RENDER and may exchange something
 * there. \a isReduced tells that the view draws its level of detail.
 */
vtkMultiProcessController* Find(vtkView* view, bool isReduced);

/**
 * Returns whether the boxes of all pieces are apart but for their faces, so that the pieces have an
 * order from every side. All processes must call it together; upside-down \a bounds are no box.
 */
bool AreApart(vtkMultiProcessController* controller, const double bounds[6]);

/// Returns whether anything is so in any process. All of them must call it together.
bool IsAnywhere(vtkMultiProcessController* controller, bool isHere);

/// Returns whether processes draw other parts of the picture, or all of them the same data.
bool HaveDisplays();
}

#endif
