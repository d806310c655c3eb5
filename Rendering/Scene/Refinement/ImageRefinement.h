// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ImageRefinement_h
#define interlume_ImageRefinement_h

#include "InterlumeSceneModule.h"
#include "Refinement/ImageKey.h"

#include <map>
#include <tuple>

class vtkRenderer;
class vtkVolume;

namespace interlume
{

/**
 * @class   ImageRefinement
 * @brief   chooses the next pass of an image that consecutive renderings refine
 *
 * The first pass takes FIRST_SECONDS, shared by the volumes of the renderer. If the complete image
 * takes more than LONG_SECONDS, the next pass takes MIDDLE_FRACTION of its time. The last pass has
 * no limit. If the first pass is expected to suffice for the complete image, it is the only one. A
 * change of the key restarts with the first pass; an aborted pass is repeated.
 *
 * There is one state for each renderer, volume and eye, so one mapper can refine several images.
 */
class INTERLUMESCENE_EXPORT ImageRefinement
{
public:
  static constexpr double FIRST_SECONDS = 0.2;
  static constexpr double LONG_SECONDS = 3.0;
  static constexpr double MIDDLE_FRACTION = 0.125;

  /// Time of a pass that shows the retained final image again.
  static constexpr double REUSED = 0.0;

  /**
   * Begins a rendering. Returns the time for its pass in seconds, at most \a allocated, or REUSED
   * if the mapper's buffer still contains the final image for this key. \a fullSeconds is the
   * expected time for the complete image.
   */
  double Begin(vtkRenderer* renderer, vtkVolume* volume, const ImageKey& key, double fullSeconds,
    double allocated);

  /// Ends the rendering of a complete image, if it has begun. Do not call it after an abort. \a
  /// isFinal is true if the image has full detail.
  void End(bool isFinal);

  /// Call this if the mapper's buffer no longer contains the image of the last rendering.
  void DropImage() { this->HasImage = false; }

  /// Clears all states, as if nothing had been rendered or after an image that needs no refinement.
  void Clear() { *this = ImageRefinement(); }

  /// Returns true if the image of the last rendering was not final.
  bool IsPending() const { return this->Last && !this->Last->IsFinal; }

private:
  struct State
  {
    ImageKey Key;
    int Pass = 0;
    bool IsFinal = false;
  };

  double GetPassSeconds(vtkRenderer* renderer, int pass, double fullSeconds) const;

  /// Renderer, volume, and 1 for the left eye.
  using Target = std::tuple<const vtkRenderer*, const vtkVolume*, int>;
  std::map<Target, State> States;
  /// State of the last rendering, or null.
  State* Last = nullptr;
  /// If true, the mapper's buffer contains the image of the last rendering.
  bool HasImage = false;
};

}

#endif
