// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkDepthPeels_h
#define vtkDepthPeels_h

#include "InterlumeSceneModule.h" // for the export macro
#include "vtkWeakPointer.h"

class vtkAbstractVolumeMapper;
class vtkRenderer;
class vtkVolume;

/**
 * @class   vtkDepthPeels
 * @brief   takes a volume out of depth peeling, for mappers that cannot draw a part between two
 * peels
 *
 * With UseDepthPeelingForVolumes vtkDualDepthPeelingPass asks a volume's mapper several times a
 * picture for what lies between two layers of polygons, in targets of its own. A mapper that draws
 * all of the volume there fills the viewport with what is no picture.
 */
class INTERLUMESCENE_EXPORT vtkDepthPeels
{
public:
  vtkDepthPeels() = default;
  ~vtkDepthPeels();
  vtkDepthPeels(const vtkDepthPeels&) = delete;
  void operator=(const vtkDepthPeels&) = delete;

  /**
   * Returns whether the volume is being peeled. If it is, the mapper has to draw nothing now: its
   * Render is called again at the end of the renderer's picture, where the volume is drawn over
   * translucent polygons as without UseDepthPeelingForVolumes.
   */
  bool Defer(vtkAbstractVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* volume);

  /// Returns true once, after the first volume that was deferred.
  bool TakeNews();

private:
  void Forget();

  vtkWeakPointer<vtkRenderer> Renderer;
  unsigned long Tag = 0;
  bool IsNews = false;
  bool WasTaken = false;
};

#endif
