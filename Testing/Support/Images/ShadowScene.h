// SPDX-License-Identifier: BSD-3-Clause
#ifndef ShadowScene_h
#define ShadowScene_h

#include "Support/Images/ImageInterpolator.h" // for the array

// Copying the smart pointers of a scene requires complete types.
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
 * An image that is rendered as a volume, with its property, matrix, cropping and clipping.
 */
struct SceneVolume
{
  vtkSmartPointer<vtkImageData> Image;
  ImageArray Array;
  vtkSmartPointer<vtkVolumeProperty> Property;
  /// Matrix of the volume, or null for the identity.
  vtkSmartPointer<vtkMatrix4x4> Matrix;
  vtkSmartPointer<vtkColorTransferFunction> TransmissionColor;

  /// Cropping region flags of vtkVolumeMapper; 0 disables cropping.
  int CroppingFlags = 0;
  std::array<double, 6> CroppingPlanes{};
  /// The negative side of each plane is removed.
  std::vector<vtkSmartPointer<vtkPlane>> ClippingPlanes;
};

/**
 * A scene with one volume, to be rendered by vtkShadowedSliceMapper and by MakeShadowImage().
 */
struct ShadowScene : SceneVolume
{
  vtkSmartPointer<vtkCamera> Camera;
  std::vector<vtkSmartPointer<vtkLight>> Lights;

  bool Shadows = true;

  std::array<int, 2> Size = { { 64, 64 } };
  /// Opaque actors. Instead of them, MakeShadowImage() uses OpaqueDistance: the distance along each
  /// pixel's view ray to the nearest actor, bottom row first. Both are empty if nothing is opaque.
  std::vector<vtkSmartPointer<vtkActor>> Actors;
  std::vector<double> OpaqueDistance;
};

}

#endif
