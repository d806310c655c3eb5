// SPDX-License-Identifier: BSD-3-Clause
#ifndef ShadowScene_h
#define ShadowScene_h

#include "Pictures/ReferenceImage.h" // for the array

// Whole types, so that a scene can be copied.
#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMatrix4x4.h"
#include "vtkPlane.h"
#include "vtkSmartPointer.h"
#include "vtkVolumeProperty.h"

#include <array>
#include <vector>

namespace reference
{

/**
 * A volume with its lights, to be drawn by vtkShadowedSliceMapper and by the reference.
 */
struct ShadowScene
{
  vtkSmartPointer<vtkImageData> Image;
  ImageArray Array;
  vtkSmartPointer<vtkVolumeProperty> Property;
  vtkSmartPointer<vtkCamera> Camera;
  std::vector<vtkSmartPointer<vtkLight>> Lights;
  /// The volume's own; null for the identity.
  vtkSmartPointer<vtkMatrix4x4> Matrix;

  bool Shadows = true;
  vtkSmartPointer<vtkColorTransferFunction> TransmissionColor;

  /// Cropping of vtkVolumeMapper: 0 is off.
  int CroppingFlags = 0;
  std::array<double, 6> CroppingPlanes{};
  /// What is on the negative side of any is clipped.
  std::vector<vtkSmartPointer<vtkPlane>> ClippingPlanes;

  std::array<int, 2> Size = { { 64, 64 } };
  /// Opaque; the reference knows them by the distance along each pixel's line of sight, rows from
  /// the bottom, empty for nothing opaque.
  std::vector<vtkSmartPointer<vtkActor>> Actors;
  std::vector<double> OpaqueDistance;
};

}

#endif
