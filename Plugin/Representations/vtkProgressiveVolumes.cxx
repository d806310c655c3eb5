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
/// Calls \a visit with the mapper of a volume if it is one of Interlume's mappers.
template <typename Visit>
void VisitMapper(vtkVolume* volume, const Visit& visit)
{
  vtkAbstractVolumeMapper* mapper = volume->GetMapper();
  if (auto* tetrahedra = vtkTimeWeightedTetrahedraMapper::SafeDownCast(mapper))
  {
    visit(tetrahedra);
  }
  else if (auto* slices = vtkShadowedSliceMapper::SafeDownCast(mapper))
  {
    visit(slices);
  }
  else if (auto* flow = vtkImplicitFlowVolumeMapper::SafeDownCast(mapper))
  {
    visit(flow);
  }
}

template <typename Visit>
void VisitMappers(vtkRenderer* renderer, const Visit& visit)
{
  vtkVolumeCollection* volumes = renderer->GetVolumes();
  vtkCollectionSimpleIterator iterator;
  volumes->InitTraversal(iterator);
  while (vtkVolume* volume = volumes->GetNextVolume(iterator))
  {
    if (volume->GetVisibility())
    {
      VisitMapper(volume, visit);
    }
  }
}
}

void vtkProgressiveVolumes::Set(vtkRenderer* renderer, bool isProgressive)
{
  VisitMappers(
    renderer, [isProgressive](auto* mapper) { mapper->SetProgressiveRendering(isProgressive); });
}

bool vtkProgressiveVolumes::IsPending(vtkRenderer* renderer)
{
  bool isPending = false;
  VisitMappers(renderer,
    [&isPending](auto* mapper) { isPending = isPending || mapper->GetRefinementPending(); });
  return isPending;
}
