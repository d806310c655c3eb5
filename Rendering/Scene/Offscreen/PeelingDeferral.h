// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_PeelingDeferral_h
#define interlume_PeelingDeferral_h

#include "InterlumeSceneModule.h"

#include "vtkWeakPointer.h"

class vtkAbstractVolumeMapper;
class vtkRenderer;
class vtkVolume;

namespace interlume
{

/**
 * @class   PeelingDeferral
 * @brief   excludes a volume from depth peeling, for mappers that cannot draw a part between two
 * peels
 *
 * With UseDepthPeelingForVolumes vtkDualDepthPeelingPass calls a volume's mapper several times per
 * image, each time for the part between two layers of polygons. A mapper that draws the full volume
 * each time fills the viewport with a wrong image.
 */
class INTERLUMESCENE_EXPORT PeelingDeferral
{
public:
  PeelingDeferral() = default;
  ~PeelingDeferral();
  PeelingDeferral(const PeelingDeferral&) = delete;
  void operator=(const PeelingDeferral&) = delete;

  /**
   * Returns whether the volume is being peeled. If it is, the mapper must draw nothing now: its
   * Render is called again at the end of the renderer's image, where the volume is drawn over
   * translucent polygons as without UseDepthPeelingForVolumes.
   */
  bool Defer(vtkAbstractVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* volume);

  /// Returns true once, after the first deferral.
  bool ConsumeFirstDeferral();

private:
  void RemoveObserver();

  vtkWeakPointer<vtkRenderer> Renderer;
  unsigned long Tag = 0;
  bool WasDeferred = false;
  bool WasConsumed = false;
};

}

#endif
