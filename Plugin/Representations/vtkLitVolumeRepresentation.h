// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkLitVolumeRepresentation_h
#define vtkLitVolumeRepresentation_h

#include "InterlumeRepresentationsModule.h" // for the export macro
#include "vtkCroppedVolumeRepresentation.h"
#include "vtkSmartPointer.h" // for the lights and textures

#include <string> // for a member

class vtkAreaLight;
class vtkProjectiveLight;
class vtkTexture;

/**
 * @class   vtkLitVolumeRepresentation
 * @brief   add a projective light and an area light to a volume representation
 *
 * A vtkProjectiveLight and a vtkAreaLight are added to the view together with the representation. A
 * light is on if its switch is on and the representation is visible. Other representations in the
 * view treat it as a standard light with the same position and color. The lights report invalid
 * values as errors and ignore them.
 *
 * @sa vtkShadowedSliceRepresentation vtkProjectiveLight vtkAreaLight
 */
class INTERLUMEREPRESENTATIONS_EXPORT vtkLitVolumeRepresentation
  : public vtkCroppedVolumeRepresentation
{
public:
  static vtkLitVolumeRepresentation* New();
  vtkTypeMacro(vtkLitVolumeRepresentation, vtkCroppedVolumeRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set the lights. Call it before adding the representation to a view. ParaView sets their
   * properties directly, except those that the methods below set. The area light is given no cone.
   * Default: new lights.
   */
  void SetProjectiveLight(vtkProjectiveLight* light);
  void SetAreaLight(vtkAreaLight* light);
  ///@}

  ///@{
  /**
   * Turn the lights on or off. Default: off.
   */
  void SetProjectiveLightSwitch(bool on);
  void SetAreaLightSwitch(bool on);
  ///@}

  ///@{
  /**
   * Set the sizes of the projective light's screen and of the area light, in world units.
   */
  void SetProjectiveLightScreenWidth(double width);
  void SetProjectiveLightScreenHeight(double height);
  void SetAreaLightWidth(double width);
  void SetAreaLightHeight(double height);
  ///@}

  ///@{
  /**
   * Set the textures for the projective light's screen and the area light's emitter. Default: null,
   * which makes the screen transparent and the emitter uniformly white.
   */
  void SetProjectiveLightImage(vtkTexture* texture);
  void SetAreaLightImage(vtkTexture* texture);
  ///@}

  void SetVisibility(bool visible) override;

protected:
  vtkLitVolumeRepresentation();
  ~vtkLitVolumeRepresentation() override;

  bool AddToView(vtkView* view) override;
  bool RemoveFromView(vtkView* view) override;
  void UpdateMapperParameters() override;

  bool IsAreaLightOn() const;
  /// Called when a light may have been turned on or off. Default: do nothing.
  virtual void LightsUpdated() {}

private:
  vtkLitVolumeRepresentation(const vtkLitVolumeRepresentation&) = delete;
  void operator=(const vtkLitVolumeRepresentation&) = delete;

  /// Turns a light on if its switch is on, its image is valid and the representation is visible,
  /// otherwise off. Reports an invalid image once.
  void UpdateLights();

  vtkSmartPointer<vtkProjectiveLight> ProjectiveLight;
  vtkSmartPointer<vtkAreaLight> AreaLight;
  vtkSmartPointer<vtkTexture> ProjectiveLightImage;
  vtkSmartPointer<vtkTexture> AreaLightImage;
  bool ProjectiveLightSwitch = false;
  bool AreaLightSwitch = false;
  std::string LightError; ///< the last error that UpdateLights has reported
};

#endif
