// SPDX-License-Identifier: BSD-3-Clause
#include "vtkProgressiveVolumes.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkImplicitFlowVolumeMapper.h"
#include "vtkRenderer.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkTimeWeightedTetrahedraMapper.h"
#include "vtkVolume.h"
#include "vtkVolumeCollection.h"

namespace
{
/// Calls \a visit with a volume and its mapper if it is one of Interlume's mappers.
template <typename Visit>
void VisitMapper(vtkVolume* volume, const Visit& visit)
{
  vtkAbstractVolumeMapper* mapper = volume->GetMapper();
  if (auto* tetrahedra = vtkTimeWeightedTetrahedraMapper::SafeDownCast(mapper))
  {
    visit(volume, tetrahedra);
  }
  else if (auto* slices = vtkShadowedSliceMapper::SafeDownCast(mapper))
  {
    visit(volume, slices);
  }
  else if (auto* flow = vtkImplicitFlowVolumeMapper::SafeDownCast(mapper))
  {
    visit(volume, flow);
  }
}

/// Calls \a visit with all of Interlume's mappers.
template <typename Visit>
void VisitMappers(vtkRenderer* renderer, const Visit& visit)
{
  vtkVolumeCollection* volumes = renderer->GetVolumes();
  vtkCollectionSimpleIterator iterator;
  volumes->InitTraversal(iterator);
  while (vtkVolume* volume = volumes->GetNextVolume(iterator))
  {
    VisitMapper(volume, visit);
  }
}
}

void vtkProgressiveVolumes::Set(vtkRenderer* renderer, bool isProgressive)
{
  VisitMappers(renderer,
    [isProgressive](vtkVolume*, auto* mapper) { mapper->SetProgressiveRendering(isProgressive); });
}

void vtkProgressiveVolumes::Restart(vtkRenderer* renderer)
{
  VisitMappers(renderer,
    [](vtkVolume*, auto* mapper)
    {
      if (mapper->GetRefinementPending())
      {
        mapper->Modified();
      }
    });
}

bool vtkProgressiveVolumes::IsPending(vtkRenderer* renderer)
{
  bool isPending = false;
  VisitMappers(renderer,
    [&isPending](vtkVolume* volume, auto* mapper)
    { isPending |= volume->GetVisibility() && mapper->GetRefinementPending(); });
  return isPending;
}
