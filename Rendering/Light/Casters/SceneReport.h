// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SceneReport_h
#define interlume_SceneReport_h

#include "vtkType.h"

#include <string>

class vtkInterlumeReport;

namespace interlume
{

/**
 * @class   SceneReport
 * @brief   counts the work of vtkShadowedScenePass for its last image
 *
 * Counts of skipped work are 0. All are 0 if no opaque actor or no light casts shadows.
 */
struct SceneReport
{
  /// The opaque actors that cast shadows, the lights that cast shadows of them, and the volumes of
  /// the scene.
  int ShadowCasters = 0;
  int Lights = 0;
  int Volumes = 0;
  /// The visible actors whose keys turn off casting and receiving shadows.
  int NonCastingActors = 0;
  int NonReceivingActors = 0;
  /// The volumes that share one set of slices and cast shadows on each other: 0, or 2 and more.
  /// SeparateVolumesReason is the error if volumes without errors of their own are rendered
  /// separately and cast shadows only on surfaces. Otherwise it is empty.
  int VolumesInSharedSlices = 0;
  std::string SeparateVolumesReason;
  /// The lit actors that receive multiply scattered light, the cells of all volumes in which opaque
  /// actors block that light, and the volumes that scatter light without receiving that of the
  /// others: 0, or 2 and more.
  int ScatteringReceivers = 0;
  int ScatteringBlockedCells = 0;
  int SeparateScatteringVolumes = 0;
  /// The lights whose color on actors comes from an image: each vtkProjectiveLight, also without an
  /// image on its screen, and each vtkAreaLight with an image on its emitter.
  int Images = 0;
  /// The depth maps of lights without extent (six for a light between the actors, otherwise one),
  /// the number of these rendered for this image, and the columns and rows of each.
  int DepthMaps = 0;
  int DepthMapsDrawn = 0;
  int DepthMapResolution = 0;
  /// The area lights among the lights, the depth maps of their samples (six for a sample between
  /// the actors, otherwise one), the number of these rendered for this image, and the columns and
  /// rows of each. DepthMaps does not include these maps.
  int AreaLights = 0;
  int SampleMaps = 0;
  int SampleMapsDrawn = 0;
  int SampleMapResolution = 0;
  /// The passes that rendered the depth seen by the camera, 0 or 1. Only volumes require it.
  int CameraDepthPasses = 0;
  /// The pixels with a surface in front of the slices of a volume, inside them and behind them, in
  /// the direction of light: regions 1, 2 and 3 of the dissertation's table 2.1, summed over sweeps
  /// and volumes.
  vtkIdType PixelsInFrontOfVolumes = 0;
  vtkIdType PixelsInsideVolumes = 0;
  vtkIdType PixelsBehindVolumes = 0;
  /// The passes that sampled the transmittance of volumes at these pixels: one per light and slab
  /// with surfaces.
  int ReceiverPasses = 0;
  /// The translucent actors of the scene, their layers seen by lights and by the camera, the
  /// segments between the latter in which volumes were rendered, and the bytes of both kinds of
  /// layers.
  int TranslucentActors = 0;
  int LightLayers = 0;
  int CameraLayers = 0;
  int SlicedSegments = 0;
  vtkIdType LightLayerBytes = 0;
  vtkIdType CameraLayerBytes = 0;
  /// The bytes of depth maps, of depth maps of samples, of the camera's depth, and of the
  /// transmittance of volumes.
  vtkIdType DepthMapBytes = 0;
  vtkIdType SampleMapBytes = 0;
  vtkIdType CameraDepthBytes = 0;
  vtkIdType TransmittanceBytes = 0;

  /// Replaces the values of a report.
  void CopyTo(vtkInterlumeReport* report) const;
};

}

#endif
