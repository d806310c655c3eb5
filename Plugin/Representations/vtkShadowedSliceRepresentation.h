// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkShadowedSliceRepresentation_h
#define vtkShadowedSliceRepresentation_h

#include "InterlumeRepresentationsModule.h" // for the export macro
#include "vtkLitVolumeRepresentation.h"
#include "vtkNew.h"          // for functions
#include "vtkSmartPointer.h" // for the mapper and the shadows of the scene
#include "vtkWeakPointer.h"  // for the renderer

#include <memory> // for what it is made of

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
 * @brief   shows images in ParaView by vtkShadowedSliceMapper, with lights of its own
 *
 * Input: a vtkImageData, or a composite dataset of images: those that fill a box together are drawn
 * as one, else the one with the most samples is drawn, with a warning. Data without an image are an
 * error, and nothing is drawn. Colour and opacity are set as for ParaView's Volume: the array to
 * colour by, its component or magnitude where it has several, or the components themselves, with
 * its colour and opacity functions, a separate array for opacity, the unit distance of the opacity,
 * shading and cropping. Without an array to colour by, or where the image lacks it, the solid
 * colour is drawn with one opacity (see vtkVolumeFunctions).
 *
 * All lights of the view shine on the volume: the light kit and additional lights. Shading is on by
 * default, unlike that of ParaView's Volume: without it the light kit's lights add up to more than
 * white.
 *
 * The representation's own lights, a vtkProjectiveLight and a vtkAreaLight, are
 * vtkLitVolumeRepresentation's.
 *
 * **Shadows of the scene**, where SceneShadows is on: as long as the representation is visible in a
 * view, that is drawn by a vtkShadowedScenePass, so that all its opaque surfaces and all its
 * volumes of this kind with Shadows on shadow each other. This is a setting of the representation
 * and not a view of its own kind: it works in the view that the user has, with all that ParaView
 * has for render views alone (lights, links, screenshots, state), and ends with the volume. The
 * pass takes the place of ParaView's drawing of props within its other passes just before each
 * picture, since the view makes these anew as its settings change (see vtkSceneShadows); where it
 * is off, the view's passes are as ParaView made them. Of several representations with SceneShadows
 * in a view each setting of the pass is the largest. With several processes surfaces shadow what
 * their own process draws.
 *
 * **With several processes** each draws its piece of the data, and ParaView composites the pictures
 * in order: without shadows that is exact but for gradients at the pieces' borders. Pieces shadow
 * each other by a coarse grid of all matter, of ShadowGridResolution cells along its longest edge,
 * that is exchanged when matter changes: each light that casts shadows reaches a piece weakened by
 * the matter of other processes on its way (see vtkPieceLight). Shadows of area lights with an
 * extent, shadows of the scene, and those in a piece that a positional light is inside of, end at
 * the pieces' borders.
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
   * Set the functions of the array to colour by; all opacities are multiplied by Opacity, 0 to 1,
   * default 1.
   */
  void SetColor(vtkColorTransferFunction* color);
  void SetScalarOpacity(vtkPiecewiseFunction* opacity);
  void SetOpacity(double opacity);
  ///@}

  /**
   * Sets the colour without an array to colour by. Default white.
   */
  void SetSolidColor(double red, double green, double blue);

  /**
   * Sets the mapper, before the representation is in a view. ParaView sets its own values on it.
   * Default a new one.
   */
  void SetMapper(vtkPieceSliceMapper* mapper);

  ///@{
  /**
   * The points of the mapper's ScatteringAlbedo: scalars, and for each the share of light, red,
   * green and blue, 0 to 1, that goes on where it meets matter; linear between them, that of the
   * next one beyond. Without points, as at first, the colours are the albedo. Without effect on
   * arrays that are drawn by their components.
   */
  void AddScatteringAlbedoPoint(double scalar, double red, double green, double blue);
  void RemoveAllScatteringAlbedoPoints();
  ///@}

  ///@{
  /**
   * The points of the mapper's PhaseTable: cosines, -1 to 1, and for each how much light goes on at
   * that angle; linear between them. The values are 0 or above, in any unit. Without points, as at
   * first, the table is even in all directions.
   */
  void AddPhaseTablePoint(double cosine, double value);
  void RemoveAllPhaseTablePoints();
  ///@}

  /**
   * Whether light takes on the colour of the matter that it passes: the mapper's TransmissionColor
   * is the colour function. Without effect on RGB components. Default off.
   */
  void SetColoredShadows(bool colored);

  /**
   * Whether surfaces and volumes of the view shadow each other. Default off.
   */
  void SetSceneShadows(bool shadows);

  /**
   * The angle in degrees under which lights of the view without an extent or a screen are seen from
   * their focal point, as long as the representation is visible: they cast soft shadows, as round
   * vtkAreaLight. Of several representations in a view the largest counts. Default 0: hard shadows.
   * Valid: 0 to 90.
   */
  void SetViewLightAngle(double angle);

  ///@{
  /**
   * Pass their values on to the vtkShadowedScenePass of the view. The defaults are those of the
   * pass.
   */
  void SetSceneDepthMapResolution(int resolution);
  void SetSceneDepthBias(double bias);
  ///@}

  /**
   * The number of cells along the longest edge of the grid by which pieces of several processes
   * shadow each other; 0: shadows end at the borders of pieces. Default 64. Valid: 0 to 256.
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

  int ShowImage(vtkImageData* image, vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector);
  /// Returns the array to colour by, null where the dataset lacks it.
  vtkDataArray* FindColors(vtkDataSet* data);
  /// Returns whether there is an array to colour by, and one for opacity that fits it.
  bool CanCombineArrays(vtkDataObject* data);
  void UpdateScalars();
  /// Tells the view whether this representation wants shadows of the scene.
  void UpdateSceneShadows();
  /// Tells other processes of the piece, and the mapper of theirs.
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
  int ShadowGridResolution = 64;
};

#endif
