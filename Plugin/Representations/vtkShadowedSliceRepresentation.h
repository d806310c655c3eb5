// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkShadowedSliceRepresentation_h
#define vtkShadowedSliceRepresentation_h

#include "InterlumeRepresentationsModule.h" // for the export macro
#include "vtkLitVolumeRepresentation.h"
#include "vtkNew.h" // for the mapper

#include <memory> // for what it is made of

class vtkColorTransferFunction;
class vtkConstantScalars;
class vtkDataArray;
class vtkImageComponent;
class vtkImageData;
class vtkPiecewiseFunction;
class vtkShadowedSliceMapper;
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
 * All lights of the view shine on the volume: the light kit and additional lights. How many of them
 * cast shadows is MaximumNumberOfShadows, here 1 at first. Shading is on at first, unlike that of
 * ParaView's Volume: without it the light kit's lights add up to more than white.
 *
 * The representation's own lights, a vtkProjectiveLight and a vtkAreaLight, are
 * vtkLitVolumeRepresentation's.
 *
 * With several processes each draws its piece of the data, and ParaView composites the pictures in
 * order: without shadows that is exact but for gradients at the pieces' borders; shadows do not
 * reach from one piece into another.
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

  ///@{
  /**
   * Pass their values on to the mapper. The defaults are those of the mapper, but for
   * MaximumNumberOfShadows.
   */
  void SetShadows(bool shadows);
  void SetMaximumNumberOfShadows(int number);
  void SetSliceSpacing(double spacing);
  void SetLightBufferSize(int size);
  void SetLightLookup(int lookup);
  void SetImageSampleDistance(double distance);
  void SetAutoAdjustSampleDistances(bool adjust);
  void SetSoftShadowMethod(int method);
  void SetNumberOfLightSamples(int number);
  ///@}

  /**
   * Whether light takes on the colour of the matter that it passes: the mapper's TransmissionColor
   * is the colour function. Without effect on RGB components. Default off.
   */
  void SetColoredShadows(bool colored);

protected:
  vtkShadowedSliceRepresentation();
  ~vtkShadowedSliceRepresentation() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
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

  vtkNew<vtkShadowedSliceMapper> Mapper;
  std::unique_ptr<vtkImageComponent> Component;
  std::unique_ptr<vtkVolumeFunctions> Functions;
  std::unique_ptr<vtkConstantScalars> Constant;
  bool ColoredShadows = false;
};

#endif
