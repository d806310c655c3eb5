// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkSceneShadows_h
#define vtkSceneShadows_h

#include "vtkNew.h" // for the pass
#include "vtkObject.h"
#include "vtkSmartPointer.h" // for what is given
#include "vtkWeakPointer.h"  // for the renderer
#include "vtkWidenedLights.h"

#include <map> // for who wants shadows

class vtkRenderer;
class vtkShadowedScenePass;
class vtkShadowedSliceMapper;

/**
 * @class   vtkSceneShadows
 * @brief   lets surfaces and volumes of one renderer of ParaView shadow each other, softly
 *
 * Whoever wants shadows, or lights with an extent, asks For the renderer, says what it wants and
 * holds what it was given. Before each picture that somebody wants shadows in, a
 * vtkShadowedScenePass takes the place of the vtkPVDefaultPass by which ParaView draws the
 * renderer, and has that for its delegate, within the passes around (camera, image processing,
 * compositing). ParaView makes all of them anew where a setting of the view changes. A renderer
 * that is drawn by another pass, as for the values of arrays or by rays, is left alone. When nobody
 * wants shadows, all is as ParaView made it.
 *
 * Where somebody wants an angle the lights are vtkWidenedLights from the start of each picture to
 * its end.
 */
class vtkSceneShadows : public vtkObject
{
public:
  static vtkSceneShadows* New();
  vtkTypeMacro(vtkSceneShadows, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The settings of the pass, and the angle of lights in degrees. Of several wishes each has the
  /// largest values.
  struct Wish
  {
    bool HasShadows = false;
    /// The mapper whose MaximumNumberOfShadows the pass has.
    vtkSmartPointer<vtkShadowedSliceMapper> Mapper;
    int DepthMapResolution = 0;
    double DepthBias = 0.0;
    double LightAngle = 0.0;
  };

  /**
   * Returns the one of \a renderer, a new one where nobody holds one.
   */
  static vtkSmartPointer<vtkSceneShadows> For(vtkRenderer* renderer);

  ///@{
  /**
   * Sets and takes away what \a owner wants.
   */
  void SetWish(const void* owner, const Wish& wish);
  void RemoveWish(const void* owner);
  ///@}

protected:
  vtkSceneShadows();
  ~vtkSceneShadows() override;

private:
  vtkSceneShadows(const vtkSceneShadows&) = delete;
  void operator=(const vtkSceneShadows&) = delete;

  /// Called before each picture: puts the pass into its place, or takes it away.
  void Arrange();
  /// Called after each picture.
  void Finish();

  vtkWeakPointer<vtkRenderer> Renderer;
  unsigned long Observers[2] = { 0, 0 };
  vtkNew<vtkShadowedScenePass> Pass;
  std::map<const void*, Wish> Wishes;
  vtkWidenedLights Lights;
};

#endif
