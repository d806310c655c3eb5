// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkLitVolumeRepresentation_h
#define vtkLitVolumeRepresentation_h

#include "InterlumeRepresentationsModule.h" // for the export macro
#include "vtkCroppedVolumeRepresentation.h"
#include "vtkNew.h"          // for the lights
#include "vtkSmartPointer.h" // for the textures

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
   * Whether the projective light shines (default off), and the values that are passed on to it.
   */
  void SetProjectiveLight(bool shines);
  void SetProjectiveLightPositional(bool positional);
  void SetProjectiveLightPosition(double x, double y, double z);
  void SetProjectiveLightFocalPoint(double x, double y, double z);
  void SetProjectiveLightViewUp(double x, double y, double z);
  void SetProjectiveLightScreenWidth(double width);
  void SetProjectiveLightScreenHeight(double height);
  void SetProjectiveLightEdgeWidth(double width);
  void SetProjectiveLightColor(double red, double green, double blue);
  void SetProjectiveLightIntensity(double intensity);
  ///@}

  /**
   * The texture whose image is on the screen of the projective light. Default null: all light
   * passes.
   */
  void SetProjectiveLightImage(vtkTexture* texture);

  /**
   * Whether the projective light casts shadows, if it is among the brightest. Default on.
   */
  void SetProjectiveLightShadows(bool shadows);

  ///@{
  /**
   * Whether the area light shines (default off), and the values that are passed on to it. A
   * positional one shines to all sides.
   */
  void SetAreaLight(bool shines);
  void SetAreaLightPositional(bool positional);
  void SetAreaLightShape(int shape);
  void SetAreaLightPosition(double x, double y, double z);
  void SetAreaLightFocalPoint(double x, double y, double z);
  void SetAreaLightViewUp(double x, double y, double z);
  void SetAreaLightWidth(double width);
  void SetAreaLightHeight(double height);
  void SetAreaLightColor(double red, double green, double blue);
  void SetAreaLightIntensity(double intensity);
  ///@}

  /**
   * The texture whose image is the emitter of the area light. Default null: uniform and white.
   */
  void SetAreaLightImage(vtkTexture* texture);

  /**
   * Whether the area light casts shadows, if it is among the brightest. Default on.
   */
  void SetAreaLightShadows(bool shadows);

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

  vtkNew<vtkProjectiveLight> Projector;
  vtkNew<vtkAreaLight> Lamp;
  vtkSmartPointer<vtkTexture> ProjectorImage;
  vtkSmartPointer<vtkTexture> LampImage;
  bool ProjectorShines = false;
  bool LampShines = false;
};

#endif
