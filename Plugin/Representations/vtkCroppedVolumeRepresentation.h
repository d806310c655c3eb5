// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkCroppedVolumeRepresentation_h
#define vtkCroppedVolumeRepresentation_h

#include "InterlumeRepresentationsModule.h" // for the export macro
#include "vtkBoundingBox.h"                 // for the bounds
#include "vtkImageVolumeRepresentation.h"

/**
 * @class   vtkCroppedVolumeRepresentation
 * @brief   crop image volumes to the same box in every process and ParaView version
 *
 * The box is the bounds of the data in all processes, scaled by the cropping scale about the
 * coordinate origin, and translated by the cropping origin. ParaView's volume representations use
 * the bounds of each process's piece, and the position of their box depends on the ParaView
 * version.
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

  /// Returns the input of a request, or null in processes without data.
  static vtkDataObject* GetInput(vtkInformationVector** inputVector);
  /// Calls RequestData of the superclass with \a image as the input.
  int RequestDataOf(vtkImageData* image, vtkInformation* request,
    vtkInformationVector** inputVector, vtkInformationVector* outputVector);

private:
  vtkCroppedVolumeRepresentation(const vtkCroppedVolumeRepresentation&) = delete;
  void operator=(const vtkCroppedVolumeRepresentation&) = delete;

  /// Computes GlobalBounds. All processes of the global controller must call it together.
  void GatherBounds();

  /// Bounds of the data in all processes.
  vtkBoundingBox GlobalBounds;
};

#endif
