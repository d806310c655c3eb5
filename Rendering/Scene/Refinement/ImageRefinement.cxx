// SPDX-License-Identifier: BSD-3-Clause
#include "Refinement/ImageRefinement.h"

#include "vtkCamera.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeCollection.h"

#include <algorithm>
#include <limits>

namespace interlume
{

namespace
{
/// Number of states above which the states of deleted renderers and volumes are removed.
constexpr std::size_t MAXIMUM_STATES = 32;

int CountVisibleVolumes(vtkRenderer* renderer)
{
  int number = 0;
  vtkVolumeCollection* volumes = renderer->GetVolumes();
  vtkCollectionSimpleIterator iterator;
  volumes->InitTraversal(iterator);
  while (vtkVolume* volume = volumes->GetNextVolume(iterator))
  {
    number += volume->GetVisibility() ? 1 : 0;
  }
  return std::max(number, 1);
}
}

double ImageRefinement::GetPassSeconds(vtkRenderer* renderer, int pass, double fullSeconds) const
{
  const double first = FIRST_SECONDS / CountVisibleVolumes(renderer);
  if (pass == 0 && fullSeconds > first)
  {
    return first;
  }
  return pass == 1 && fullSeconds > LONG_SECONDS ? MIDDLE_FRACTION * fullSeconds
                                                 : std::numeric_limits<double>::infinity();
}

double ImageRefinement::Begin(vtkRenderer* renderer, vtkVolume* volume, const ImageKey& key,
  double fullSeconds, double allocated)
{
  if (this->States.size() > MAXIMUM_STATES)
  {
    this->Clear();
  }
  State* const last = this->Last;
  this->Last = &this->States[{ renderer, volume, renderer->GetActiveCamera()->GetLeftEye() }];
  State& state = *this->Last;
  if (!(state.Key == key))
  {
    state = State{ key };
  }
  if (state.IsFinal && this->HasImage && last == this->Last)
  {
    return REUSED;
  }
  this->HasImage = false;
  // A final image that was overwritten is drawn again without coarse passes.
  const double seconds = state.IsFinal ? std::numeric_limits<double>::infinity()
                                       : this->GetPassSeconds(renderer, state.Pass, fullSeconds);
  return std::min(allocated, seconds);
}

void ImageRefinement::End(bool isFinal)
{
  if (this->Last)
  {
    ++this->Last->Pass;
    this->Last->IsFinal = isFinal;
    this->HasImage = isFinal;
  }
}

}
