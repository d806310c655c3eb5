// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkSceneShadows_h
#define vtkSceneShadows_h

#include "vtkNew.h" // for the pass
#include "vtkObject.h"
#include "vtkSmartPointer.h" // for mappers
#include "vtkWeakPointer.h"  // for the renderer
#include "vtkTemporaryAreaLights.h"

#include <map> // for requests

class vtkRenderer;
class vtkShadowedScenePass;
class vtkShadowedSliceMapper;

/**
 * @class   vtkSceneShadows
 * @brief   adds shadows between all surfaces and volumes of a ParaView renderer
 *
 * A representation that requires shadows, or lights with an extent, calls GetOrCreate, sets its
 * request and keeps the returned object. If any request has shadows, a vtkShadowedScenePass
 * replaces ParaView's vtkPVDefaultPass before each rendering and delegates to it. The outer camera,
 * image-processing and compositing passes are unchanged. The pass must be checked before each
 * rendering, because ParaView recreates all passes when a setting of the view changes. Renderers
 * with another pass, such as for ray tracing or for rendering array values, are not changed.
 * Without requests for shadows, ParaView's pass is restored.
 *
 * If any request has a light angle or scale, vtkTemporaryAreaLights replaces the lights during each
 * rendering.
 */
class vtkSceneShadows : public vtkObject
{
public:
  static vtkSceneShadows* New();
  vtkTypeMacro(vtkSceneShadows, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Settings of the pass, and the angular diameter of the lights in degrees. The maximum of each
  /// setting over all requests is used, unless stated otherwise.
  struct Request
  {
    bool HasShadows = false;
    /// Mapper whose MaximumNumberOfShadowLights the pass uses.
    vtkSmartPointer<vtkShadowedSliceMapper> Mapper;
    int DepthMapResolution = 0;
    double DepthBias = 0.0;
    double LightAngle = 0.0;
    /// Factor for the intensities of the view's lights. The minimum over all requests is used.
    double LightScale = 1.0;
  };

  /**
   * Returns the vtkSceneShadows of \a renderer. Creates it if it does not exist.
   */
  static vtkSmartPointer<vtkSceneShadows> GetOrCreate(vtkRenderer* renderer);

  ///@{
  /**
   * Sets or removes the request of \a requester.
   */
  void SetRequest(const void* requester, const Request& request);
  void RemoveRequest(const void* requester);
  ///@}

protected:
  vtkSceneShadows();
  ~vtkSceneShadows() override;

private:
  vtkSceneShadows(const vtkSceneShadows&) = delete;
  void operator=(const vtkSceneShadows&) = delete;

  /// Called before each rendering: replaces the lights, and installs or removes the pass.
  void UpdatePass();
  /// Called after each rendering, because UpdatePass may replace the lights.
  void RestoreLights();

  vtkWeakPointer<vtkRenderer> Renderer;
  unsigned long Observers[2] = { 0, 0 };
  vtkNew<vtkShadowedScenePass> Pass;
  std::map<const void*, Request> Requests;
  vtkTemporaryAreaLights Lights;
};

#endif
