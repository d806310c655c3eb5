// SPDX-License-Identifier: BSD-3-Clause
#ifndef ShadowScene_h
#define ShadowScene_h

#include "Support/Images/ReferenceImage.h" // for the array

// Complete types, so that a scene can be copied.
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
 * An image as a volume, with its property, matrix, cropping and clipping.
 */
struct SceneVolume
{
  vtkSmartPointer<vtkImageData> Image;
  ImageArray Array;
  vtkSmartPointer<vtkVolumeProperty> Property;
  /// Matrix of the volume, or null for the identity.
  vtkSmartPointer<vtkMatrix4x4> Matrix;
  vtkSmartPointer<vtkColorTransferFunction> TransmissionColor;

  /// Cropping of vtkVolumeMapper; 0 is off.
  int CroppingFlags = 0;
  std::array<double, 6> CroppingPlanes{};
  /// The negative side of each plane is clipped.
  std::vector<vtkSmartPointer<vtkPlane>> ClippingPlanes;
};

/**
 * A volume and its lights, for vtkShadowedSliceMapper and for the reference.
 */
struct ShadowScene : SceneVolume
{
  vtkSmartPointer<vtkCamera> Camera;
  std::vector<vtkSmartPointer<vtkLight>> Lights;

  bool Shadows = true;

  std::array<int, 2> Size = { { 64, 64 } };
  /// Opaque actors. The reference uses OpaqueDistance instead: their distance along each pixel's
  /// view ray, with rows from the bottom. Both are empty if nothing is opaque.
  std::vector<vtkSmartPointer<vtkActor>> Actors;
  std::vector<double> OpaqueDistance;
};

}

#endif
