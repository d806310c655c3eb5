// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkShadowedSliceRepresentation_h
#define vtkShadowedSliceRepresentation_h

#include "InterlumeRepresentationsModule.h" // for the export macro
#include "vtkLitVolumeRepresentation.h"
#include "vtkNew.h"          // for functions
#include "vtkSmartPointer.h" // for the mapper and the shadows of the scene
#include "vtkWeakPointer.h"  // for the renderer

#include <memory> // for members

class vtkColorTransferFunction;
class vtkConstantScalars;
class vtkDataArray;
class vtkImageComponent;
class vtkImageData;
class vtkPieceSliceMapper;
class vtkPiecewiseFunction;
class vtkRenderer;
class vtkSceneShadows;
class vtkVolumeFunctions;

/**
 * @class   vtkShadowedSliceRepresentation
 * @brief   render images in ParaView with vtkShadowedSliceMapper and additional lights
 *
 * **Input**: a vtkImageData, or a composite dataset of images. Images that fill a box together are
 * joined. Otherwise, the image with the most samples is rendered.
 *
 * **Color and opacity** are set as for ParaView's Volume: an array with its color and opacity
 * functions, a component, the magnitude or all components, a separate opacity array, the opacity
 * unit distance, shading and cropping. If there is no color array, or the image lacks it, the solid
 * color and a constant opacity are used (see vtkVolumeFunctions).
 *
 * **Lights**: all lights of the view, and the two lights of vtkLitVolumeRepresentation. Shading is
 * on by default, unlike in ParaView's Volume. Without shading, the lights of the light kit add up
 * to more than white.
 *
 * **Scene shadows**: if SceneShadows is on and the representation is visible, the view is rendered
 * by a vtkShadowedScenePass. All opaque surfaces of the view and all volumes of this type with
 * Shadows on then shadow each other. Because this is a setting of the representation, not a
 * separate view type, it works with all features of render views. If several representations of a
 * view have SceneShadows on, the maximum of each setting of the pass is used (see vtkSceneShadows).
 * With several processes, surfaces shadow only the data of their own process.
 *
 * **Several processes**: each process renders its piece, and ParaView composites the images in
 * visibility order. Without shadows, the result is exact except for gradients at the boundaries of
 * pieces. Pieces shadow each other through a coarse grid of extinction, with ShadowGridResolution
 * cells along the longest edge, which is exchanged when the medium changes (see vtkPieceLight).
 * Soft shadows of area lights, scene shadows, and shadows from a positional light inside a piece
 * end at the boundary of the piece.
 *
 * **Errors** (vtkErrorMacro, nothing is drawn): an input without images. **Warnings**
 * (vtkWarningMacro): datasets that are not rendered; a missing opacity array.
 */
class INTERLUMEREPRESENTATIONS_EXPORT vtkShadowedSliceRepresentation
  : public vtkLitVolumeRepresentation
{
public:
  static vtkShadowedSliceRepresentation* New();
  vtkTypeMacro(vtkShadowedSliceRepresentation, vtkLitVolumeRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set the color and opacity functions of the color array, and a factor for all opacities.
   * Default: null, null, 1. Valid factors: 0 to 1; clamped.
   */
  void SetColor(vtkColorTransferFunction* color);
  void SetScalarOpacity(vtkPiecewiseFunction* opacity);
  void SetOpacity(double opacity);
  ///@}

  /**
   * Set the color to use if there is no color array. Default: white.
   */
  void SetSolidColor(double red, double green, double blue);

  /**
   * Set the mapper. Call it before adding the representation to a view. ParaView sets the mapper's
   * properties directly. Default: a new mapper.
   */
  void SetMapper(vtkPieceSliceMapper* mapper);

  ///@{
  /**
   * Add or remove points of the mapper's ScatteringAlbedo: a scalar, and the albedo in red, green
   * and blue, 0 to 1. The albedo is interpolated linearly between the points and constant outside
   * their range. It has no effect on arrays whose components are colors. Default: no points; the
   * colors are the albedo.
   */
  void AddScatteringAlbedoPoint(double scalar, double red, double green, double blue);
  void RemoveAllScatteringAlbedoPoints();
  ///@}

  ///@{
  /**
   * Add or remove points of the mapper's PhaseTable: the cosine of a scattering angle, -1 to 1, and
   * the relative amount of light scattered by that angle, 0 or above. The table is interpolated
   * linearly and normalized. Default: no points; scattering is isotropic.
   */
  void AddPhaseTablePoint(double cosine, double value);
  void RemoveAllPhaseTablePoints();
  ///@}

  /**
   * If true, transmitted light takes on the color of the medium: the mapper's TransmissionColor is
   * the color function. It has no effect on arrays with RGB components. Default: off.
   */
  void SetColoredShadows(bool colored);

  /**
   * If true, surfaces and volumes of the view shadow each other. Default: off.
   */
  void SetSceneShadows(bool shadows);

  /**
   * Set the angular diameter, in degrees, of the view's lights as seen from their focal point.
   * While the representation is visible, these lights act as round vtkAreaLights and cast soft
   * shadows. Area lights and projective lights are not changed. The maximum over all
   * representations of a view is used. Default: 0, hard shadows. Valid: 0 to 90; clamped.
   */
  void SetViewLightAngle(double angle);

  /**
   * Set the factor for the intensities of the view's lights while the area light of the
   * representation is on. Area lights and projective lights are not changed. The minimum over all
   * representations of a view is used. Default: 1. Valid: 0 to 1; clamped.
   */
  void SetViewLightScale(double scale);

  ///@{
  /**
   * Set DepthMapResolution and DepthBias of the view's vtkShadowedScenePass, which documents their
   * valid values. Default: 1024, 1.
   */
  void SetSceneDepthMapResolution(int resolution);
  void SetSceneDepthBias(double bias);
  ///@}

  /**
   * Set the number of cells along the longest edge of the grid used to cast shadows from the
   * piece of one process onto that of another. With 0, shadows end at the boundaries of pieces.
   * Default: 64. Valid: 0 to 256; clamped.
   */
  void SetShadowGridResolution(int resolution);

  int ProcessViewRequest(
    vtkInformationRequestKey* request, vtkInformation* input, vtkInformation* output) override;

  void SetVisibility(bool visible) override;

protected:
  vtkShadowedSliceRepresentation();
  ~vtkShadowedSliceRepresentation() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  bool AddToView(vtkView* view) override;
  bool RemoveFromView(vtkView* view) override;
  void UpdateMapperParameters() override;

private:
  vtkShadowedSliceRepresentation(const vtkShadowedSliceRepresentation&) = delete;
  void operator=(const vtkShadowedSliceRepresentation&) = delete;

  /// Calls RequestData of the superclass for \a image, which is null in a process without data.
  int ShowImage(vtkImageData* image, vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector);
  /// Returns the color array, or null if the dataset lacks it.
  vtkDataArray* FindColors(vtkDataSet* data);
  /// Returns true if the color array and a matching opacity array exist.
  bool CanCombineArrays(vtkDataObject* data);
  /// Sets the input and functions of the mapper for the current color array, if any.
  void UpdateScalars();
  /// Sets or removes this representation's request in the vtkSceneShadows of the renderer.
  void UpdateSceneShadows();
  void LightsUpdated() override { this->UpdateSceneShadows(); }
  /// Exchanges the extinction of the pieces if several processes render.
  void GatherPieces(bool isReduced);

  vtkSmartPointer<vtkPieceSliceMapper> Mapper;
  std::unique_ptr<vtkImageComponent> Component;
  std::unique_ptr<vtkVolumeFunctions> Functions;
  std::unique_ptr<vtkConstantScalars> Constant;
  vtkNew<vtkColorTransferFunction> Albedo;
  vtkNew<vtkPiecewiseFunction> PhaseTable;
  vtkWeakPointer<vtkRenderer> ViewRenderer;
  vtkSmartPointer<vtkSceneShadows> SceneShadows;
  bool ColoredShadows = false;
  bool HasSceneShadows = false;
  int SceneDepthMapResolution = 1024;
  double SceneDepthBias = 1.0;
  double ViewLightAngle = 0.0;
  double ViewLightScale = 1.0;
  int ShadowGridResolution = 64;
};

#endif
