// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkCroppedVolumeRepresentation_h
#define vtkCroppedVolumeRepresentation_h

#include "InterlumeRepresentationsModule.h" // for the export macro
#include "vtkBoundingBox.h"                 // for the box
#include "vtkImageVolumeRepresentation.h"

/**
 * @class   vtkCroppedVolumeRepresentation
 * @brief   crops volumes of images to the same box in every process and version of ParaView
 *
 * The box is the bounds of the data, of all processes' pieces, times the cropping scale, about the
 * origin of the coordinates, moved by the cropping origin. ParaView's own volumes crop each
 * process's piece by bounds of its own, and place the box otherwise from one version to the next.
 *
 * @sa vtkLitVolumeRepresentation vtkInflowTextureRepresentation
 */
class INTERLUMEREPRESENTATIONS_EXPORT vtkCroppedVolumeRepresentation
  : public vtkImageVolumeRepresentation
{
public:
  static vtkCroppedVolumeRepresentation* New();
  vtkTypeMacro(vtkCroppedVolumeRepresentation, vtkImageVolumeRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  int ProcessViewRequest(
    vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo) override;

protected:
  vtkCroppedVolumeRepresentation();
  ~vtkCroppedVolumeRepresentation() override;

  void UpdateMapperParameters() override;

  /// Returns the input of a request; null in processes that only show the outline.
  static vtkDataObject* GetInput(vtkInformationVector** inputVector);
  /// Executes the request of the superclass with \a image in place of the input.
  int RequestDataOf(vtkImageData* image, vtkInformation* request,
    vtkInformationVector** inputVector, vtkInformationVector* outputVector);

private:
  vtkCroppedVolumeRepresentation(const vtkCroppedVolumeRepresentation&) = delete;
  void operator=(const vtkCroppedVolumeRepresentation&) = delete;

  /// Takes the bounds of all pieces. All processes that have pieces must call it together.
  void GatherBounds();

  vtkBoundingBox WholeBounds;
};

#endif
