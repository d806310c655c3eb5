// SPDX-License-Identifier: BSD-3-Clause
#ifndef ShadowScene_h
#define ShadowScene_h

#include "Support/Pictures/ReferenceImage.h" // for the array

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
 * An image as a volume: what it is made of, where it is, what is cut away from it.
 */
struct SceneVolume
{
  vtkSmartPointer<vtkImageData> Image;
  ImageArray Array;
  vtkSmartPointer<vtkVolumeProperty> Property;
  /// The volume's own; null for the identity.
  vtkSmartPointer<vtkMatrix4x4> Matrix;
  vtkSmartPointer<vtkColorTransferFunction> TransmissionColor;

  /// Cropping of vtkVolumeMapper: 0 is off.
  int CroppingFlags = 0;
  std::array<double, 6> CroppingPlanes{};
  /// What is on the negative side of any is clipped.
  std::vector<vtkSmartPointer<vtkPlane>> ClippingPlanes;
};

/**
 * A volume with its lights, to be drawn by vtkShadowedSliceMapper and by the reference.
 */
struct ShadowScene : SceneVolume
{
  vtkSmartPointer<vtkCamera> Camera;
  std::vector<vtkSmartPointer<vtkLight>> Lights;

  bool Shadows = true;

  std::array<int, 2> Size = { { 64, 64 } };
  /// Opaque; the reference knows them by the distance along each pixel's line of sight, rows from
  /// the bottom, empty for nothing opaque.
  std::vector<vtkSmartPointer<vtkActor>> Actors;
  std::vector<double> OpaqueDistance;
};

}

#endif
