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
 * @brief   statistics of the last frame of vtkShadowedScenePass
 *
 * Counters of skipped work are 0. All counters are 0 if Shadows is off.
 */
struct SceneReport
{
  /// Number of opaque actors that cast shadows, number of lights that cast shadows of actors, and
  /// number of volumes in the scene.
  int ShadowCasters = 0;
  int Lights = 0;
  int Volumes = 0;
  /// Number of visible actors whose property keys disable casting or receiving shadows.
  int NonCastingActors = 0;
  int NonReceivingActors = 0;
  /// Number of volumes that share one set of slices and cast shadows on each other. The number is
  /// never 1. SeparateVolumesReason is the reason why volumes are rendered one by one, in which
  /// case they cast shadows only on surfaces. Otherwise it is empty.
  int VolumesInSharedSlices = 0;
  std::string SeparateVolumesReason;
  /// Number of actors that receive multiply scattered light, number of grid cells in which opaque
  /// actors block this light, and number of volumes that scatter light independently of each other.
  /// The last number is never 1.
  int ScatteringReceivers = 0;
  int ScatteringBlockedCells = 0;
  int SeparateScatteringVolumes = 0;
  /// Number of lights whose color on actors is modified by a screen or an image: all lights of type
  /// vtkProjectiveLight, and those of type vtkAreaLight whose emitter image is not white on
  /// average.
  int Images = 0;
  /// Number of shadow maps of lights other than area lights (one or six per light), number of these
  /// maps rendered for this frame, and number of columns and rows of each map.
  int DepthMaps = 0;
  int DepthMapsDrawn = 0;
  int DepthMapResolution = 0;
  /// Number of area lights that cast shadows, number of shadow maps of their samples (one or six
  /// per sample), number of these maps rendered for this frame, and number of columns and rows of
  /// each map. DepthMaps does not include these maps.
  int AreaLights = 0;
  int SampleMaps = 0;
  int SampleMapsDrawn = 0;
  int SampleMapResolution = 0;
  /// Number of passes that rendered the scene's depth seen by the camera, 0 or 1. Only volumes
  /// require this depth.
  int CameraDepthPasses = 0;
  /// Number of pixels whose surface is in front of the slices of volumes (or is reached by no light
  /// through them), between the slices, and behind them, as seen from the light. Summed over all
  /// sweeps.
  vtkIdType PixelsInFrontOfVolumes = 0;
  vtkIdType PixelsInsideVolumes = 0;
  vtkIdType PixelsBehindVolumes = 0;
  /// Number of passes that computed the transmittance of volumes at the surfaces between or behind
  /// the slices, summed over volumes, lights and slabs.
  int ReceiverPasses = 0;
  /// Number of translucent actors, number of their layers seen from the lights, number of their
  /// layers seen from the camera, and number of segments into which the camera's layers divide the
  /// volumes. Bytes of the layers of the lights and of the camera.
  int TranslucentActors = 0;
  int LightLayers = 0;
  int CameraLayers = 0;
  int SlicedSegments = 0;
  vtkIdType LightLayerBytes = 0;
  vtkIdType CameraLayerBytes = 0;
  /// Bytes of the shadow maps counted by DepthMaps and by SampleMaps, of the depth seen by the
  /// camera, and of the transmittance of the volumes at surfaces.
  vtkIdType DepthMapBytes = 0;
  vtkIdType SampleMapBytes = 0;
  vtkIdType CameraDepthBytes = 0;
  vtkIdType TransmittanceBytes = 0;

  /// Replaces all values of \a report with these values.
  void CopyTo(vtkInterlumeReport* report) const;
};

}

#endif
