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
 * @brief   counts the work of vtkShadowedScenePass for its last frame
 *
 * Counters of skipped work are 0. All counters are 0 if no opaque actor or no light casts shadows.
 */
struct SceneReport
{
  /// Number of opaque actors that cast shadows, of lights for which they cast shadows, and of
  /// volumes in the scene.
  int ShadowCasters = 0;
  int Lights = 0;
  int Volumes = 0;
  /// Number of visible actors whose property keys turn off casting or receiving shadows.
  int NonCastingActors = 0;
  int NonReceivingActors = 0;
  /// Number of volumes that share one set of slices and cast shadows on each other: 0, or at least
  /// 2. SeparateVolumesReason is an error message if valid volumes are rendered separately and cast
  /// shadows only on surfaces. Otherwise it is empty.
  int VolumesInSharedSlices = 0;
  std::string SeparateVolumesReason;
  /// Number of lit actors that receive multiply scattered light, of cells in which opaque actors
  /// block this light, and of volumes that scatter light without receiving light from each other:
  /// 0, or at least 2.
  int ScatteringReceivers = 0;
  int ScatteringBlockedCells = 0;
  int SeparateScatteringVolumes = 0;
  /// Number of lights whose color on actors comes from an image: each vtkProjectiveLight, with or
  /// without an image on its screen, and each vtkAreaLight with an image on its emitter.
  int Images = 0;
  /// Number of shadow maps of lights without extent (six for a light between the actors, otherwise
  /// one), number of maps rendered for this frame, and columns and rows of each map.
  int DepthMaps = 0;
  int DepthMapsDrawn = 0;
  int DepthMapResolution = 0;
  /// Number of area lights that cast shadows, number of shadow maps of their samples (six for a
  /// sample between the actors, otherwise one), number of these maps rendered for this frame, and
  /// columns and rows of each map. DepthMaps does not include these maps.
  int AreaLights = 0;
  int SampleMaps = 0;
  int SampleMapsDrawn = 0;
  int SampleMapResolution = 0;
  /// Number of passes that rendered the camera's depth, 0 or 1. Only volumes require it.
  int CameraDepthPasses = 0;
  /// Number of pixels with a surface in front of a volume's slices, inside them and behind them, in
  /// the direction of light, summed over sweeps and volumes.
  vtkIdType PixelsInFrontOfVolumes = 0;
  vtkIdType PixelsInsideVolumes = 0;
  vtkIdType PixelsBehindVolumes = 0;
  /// Number of passes that sampled the transmittance of volumes at these pixels: one per light and
  /// slab with surfaces.
  int ReceiverPasses = 0;
  /// Number of translucent actors, of their layers seen by lights, of their layers seen by the
  /// camera, and of the segments between the camera's layers in which volumes were rendered. Bytes
  /// of the layers of lights and of the camera.
  int TranslucentActors = 0;
  int LightLayers = 0;
  int CameraLayers = 0;
  int SlicedSegments = 0;
  vtkIdType LightLayerBytes = 0;
  vtkIdType CameraLayerBytes = 0;
  /// Bytes of the shadow maps of lights without extent and of area lights, of the camera's depth,
  /// and of the volumes' transmittance.
  vtkIdType DepthMapBytes = 0;
  vtkIdType SampleMapBytes = 0;
  vtkIdType CameraDepthBytes = 0;
  vtkIdType TransmittanceBytes = 0;

  /// Replaces all values of \a report by these values.
  void CopyTo(vtkInterlumeReport* report) const;
};

}

#endif
