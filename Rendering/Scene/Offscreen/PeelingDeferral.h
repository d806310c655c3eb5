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
 * @brief   excludes a volume from depth peeling, for mappers that cannot draw a slab between two
 * peels
 *
 * With UseDepthPeelingForVolumes, vtkDualDepthPeelingPass calls a volume's mapper several times per
 * frame, each time for the part between two layers of polygons. A mapper that draws the complete
 * volume each time would produce an incorrect frame.
 */
class INTERLUMESCENE_EXPORT PeelingDeferral
{
public:
  PeelingDeferral() = default;
  ~PeelingDeferral();
  PeelingDeferral(const PeelingDeferral&) = delete;
  void operator=(const PeelingDeferral&) = delete;

  /**
   * Returns true if the volume is being peeled. In this case, the mapper must not draw. Its Render
   * is called again at the end of the renderer's frame to draw the volume over translucent
   * polygons, as if UseDepthPeelingForVolumes were off. The first time, the mapper warns that it
   * ignores the setting.
   */
  bool Defer(vtkAbstractVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* volume);

private:
  void RemoveObserver();

  vtkWeakPointer<vtkRenderer> Renderer;
  unsigned long Tag = 0;
  bool HasWarned = false;
};

}

#endif
