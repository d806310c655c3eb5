// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkLitVolumeRepresentation_h
#define vtkLitVolumeRepresentation_h

#include "InterlumeRepresentationsModule.h" // for the export macro
#include "vtkCroppedVolumeRepresentation.h"
#include "vtkSmartPointer.h" // for the lights and textures

class vtkAreaLight;
class vtkProjectiveLight;
class vtkTexture;

/**
 * @class   vtkLitVolumeRepresentation
 * @brief   has a projective light and an area light of its own, which come and go with it
 *
 * Each of the lights, a vtkProjectiveLight and a vtkAreaLight, is one of the view's lights as long
 * as the representation is in the view; it is switched on while it shines and the representation is
 * visible. Other representations see lights of that position and colour without a screen or an
 * extent. Values that the lights refuse are their errors and change nothing.
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
   * Set the lights, before the representation is in a view. ParaView sets its own values on them,
   * except those that follow. Default new ones. The area light has no cone.
   */
  void SetProjectiveLight(vtkProjectiveLight* light);
  void SetAreaLight(vtkAreaLight* light);
  ///@}

  ///@{
  /**
   * Set whether the lights shine. Default off.
   */
  void SetProjectiveLightSwitch(bool shines);
  void SetAreaLightSwitch(bool shines);
  ///@}

  ///@{
  /**
   * Set the size of the projective light's screen and of the area light.
   */
  void SetProjectiveLightScreenWidth(double width);
  void SetProjectiveLightScreenHeight(double height);
  void SetAreaLightWidth(double width);
  void SetAreaLightHeight(double height);
  ///@}

  ///@{
  /**
   * Set the textures whose images are on the projective light's screen and the area light's
   * emitter. Default null: all light passes, and the emitter is uniform and white.
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

private:
  vtkLitVolumeRepresentation(const vtkLitVolumeRepresentation&) = delete;
  void operator=(const vtkLitVolumeRepresentation&) = delete;

  /// Switches the lights.
  void UpdateLights();

  vtkSmartPointer<vtkProjectiveLight> ProjectiveLight;
  vtkSmartPointer<vtkAreaLight> AreaLight;
  vtkSmartPointer<vtkTexture> ProjectiveLightImage;
  vtkSmartPointer<vtkTexture> AreaLightImage;
  bool ProjectiveLightSwitch = false;
  bool AreaLightSwitch = false;
};

#endif
