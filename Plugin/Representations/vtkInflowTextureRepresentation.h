// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkInflowTextureRepresentation_h
#define vtkInflowTextureRepresentation_h

#include "InterlumeRepresentationsModule.h" // for the export macro
#include "vtkCroppedVolumeRepresentation.h"
#include "vtkNew.h"          // for functions
#include "vtkSmartPointer.h" // for the mapper and textures

#include <string> // for the array

class vtkImageData;
class vtkImplicitFlowVolumeMapper;
class vtkPiecewiseFunction;
class vtkTexture;

/**
 * @class   vtkInflowTextureRepresentation
 * @brief   render implicit flow fields in ParaView with vtkImplicitFlowVolumeMapper
 *
 * Input: a vtkImageData with the arrays of vtkImplicitFlowField. The colors come from images on the
 * termination surfaces; ParaView's color array is ignored. With several processes, each process
 * renders its piece of the data, and ParaView composites the images in visibility order.
 *
 * Errors (vtkErrorMacro, nothing is drawn): an input that is not an image; missing arrays, which
 * the mapper reports by name.
 */
class INTERLUMEREPRESENTATIONS_EXPORT vtkInflowTextureRepresentation
  : public vtkCroppedVolumeRepresentation
{
public:
  static vtkInflowTextureRepresentation* New();
  vtkTypeMacro(vtkInflowTextureRepresentation, vtkCroppedVolumeRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Set the mapper. Call it before adding the representation to a view. ParaView sets the mapper's
   * properties directly. Default: a new mapper.
   */
  void SetMapper(vtkImplicitFlowVolumeMapper* mapper);

  ///@{
  /**
   * Set the image on all termination surfaces, another image for one surface, the id of that
   * surface, and the detail image. Null removes an image. Default: null, null, 0, null. Valid ids:
   * 0 and above; clamped.
   */
  void SetInflowTexture(vtkTexture* texture);
  void SetSurfaceTexture(vtkTexture* texture);
  void SetSurfaceId(int id);
  void SetDetailTexture(vtkTexture* texture);
  ///@}

  enum Patterns
  {
    NO_PATTERN = 0,
    CHECKERBOARD = 1,
    BANDS = 2
  };
  /**
   * Set the pattern on all termination surfaces while there is no image for all surfaces. Every
   * second square or band is transparent. Default: NO_PATTERN. Valid: see Patterns; clamped.
   */
  void SetInflowPattern(int pattern);

  ///@{
  /**
   * Set the color and opacity of surfaces without an image (DefaultColor of the mapper).
   */
  void SetDefaultColor(double red, double green, double blue);
  void SetDefaultOpacity(double opacity);
  ///@}

  /**
   * Set the fraction of each time period during which color is injected on the termination
   * surfaces. The pulse begins with the period: the mapper's TimeGate is 1 during the pulse and 0
   * after it. With a fraction of 1, there is no gate. Default: 1. Valid: 0 to 1; clamped.
   */
  void SetPulseLength(double fraction);

  ///@{
  /**
   * If on, multiply the opacity by a factor that depends on a point array. The factor increases
   * linearly from 0 to 1 between the two values of the range; if the first value is larger, lower
   * values are more opaque. The first four arguments of SelectInflowOpacityArray are ignored.
   * Default: off, no array, range (0, 1). Valid: finite ranges.
   */
  void SetUseOpacityArray(bool use);
  void SelectInflowOpacityArray(int, int, int, int, const char* name);
  void SetOpacityRange(double from, double to);
  ///@}

  /// Select the array that determines the shading if Shade is on. The first four arguments are
  /// ignored. Default: none.
  void SelectShadingArray(int, int, int, int, const char* name);

protected:
  vtkInflowTextureRepresentation();
  ~vtkInflowTextureRepresentation() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  void UpdateMapperParameters() override;

private:
  vtkInflowTextureRepresentation(const vtkInflowTextureRepresentation&) = delete;
  void operator=(const vtkInflowTextureRepresentation&) = delete;

  vtkSmartPointer<vtkImplicitFlowVolumeMapper> Mapper;
  vtkNew<vtkPiecewiseFunction> Gate;
  vtkNew<vtkPiecewiseFunction> Opacity;
  bool UseOpacityArray = false;
  std::string OpacityArray;
  vtkSmartPointer<vtkTexture> InflowTexture;
  vtkSmartPointer<vtkTexture> SurfaceTexture;
  vtkSmartPointer<vtkTexture> DetailTexture;
  int SurfaceId = 0;
  int InflowPattern = NO_PATTERN;
  vtkSmartPointer<vtkImageData> PatternImage;
};

#endif
