// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkInflowTextureRepresentation_h
#define vtkInflowTextureRepresentation_h

#include "InterlumeRepresentationsModule.h" // for the export macro
#include "vtkCroppedVolumeRepresentation.h"
#include "vtkNew.h"          // for functions
#include "vtkSmartPointer.h" // for the mapper and textures

#include <string> // for the array

class vtkImplicitFlowVolumeMapper;
class vtkPiecewiseFunction;
class vtkTexture;

/**
 * @class   vtkInflowTextureRepresentation
 * @brief   shows implicit flow fields in ParaView by vtkImplicitFlowVolumeMapper
 *
 * Input: a vtkImageData with the arrays of vtkImplicitFlowField; without them the mapper's error
 * says which are missing, and nothing is drawn. Other datasets are an error, and nothing is drawn.
 * Colours are those of images that are painted on the termination surfaces; ParaView's array to
 * colour by has no part.
 *
 * With several processes each draws its piece of the data, and ParaView composites the pictures in
 * order.
 */
class INTERLUMEREPRESENTATIONS_EXPORT vtkInflowTextureRepresentation
  : public vtkCroppedVolumeRepresentation
{
public:
  static vtkInflowTextureRepresentation* New();
  vtkTypeMacro(vtkInflowTextureRepresentation, vtkCroppedVolumeRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Sets the mapper, before the representation is in a view. ParaView sets its own values on it.
   * Default a new one.
   */
  void SetMapper(vtkImplicitFlowVolumeMapper* mapper);

  ///@{
  /**
   * The images on all surfaces, on the surface of SurfaceId alone, and that of the details. Default
   * none, none, 0, none. Valid ids: 0 and above; clamped.
   */
  void SetInflowTexture(vtkTexture* texture);
  void SetSurfaceTexture(vtkTexture* texture);
  void SetSurfaceId(int id);
  void SetDetailTexture(vtkTexture* texture);
  ///@}

  ///@{
  /**
   * Colour and opacity of surfaces without an image: the mapper's DefaultColor.
   */
  void SetDefaultColor(double red, double green, double blue);
  void SetDefaultOpacity(double opacity);
  ///@}

  /**
   * The share of each period in which paint is put in, from its start: a TimeGate of the mapper
   * that is 1 for that long and then 0. Default 1: always, without a gate. Valid: 0 to 1; clamped.
   */
  void SetPulseLength(double share);

  ///@{
  /**
   * Whether a further array takes part in opacity, which (the first four numbers have no meaning),
   * and the values from which and up to which opacity grows from none to all. A range that falls
   * has most at lower values. Default no, none, 0, 1. Valid ranges: finite.
   */
  void SetUseOpacityArray(bool use);
  void SelectInflowOpacityArray(int, int, int, int, const char* name);
  void SetOpacityRange(double from, double to);
  ///@}

  /// The array that shades where Shade is on; the first four numbers have no meaning. Default none.
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
};

#endif
