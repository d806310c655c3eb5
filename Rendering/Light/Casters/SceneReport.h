// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkShadowedSceneReport_h
#define vtkShadowedSceneReport_h

#include "InterlumeLightModule.h" // for the export macro
#include "vtkIndent.h"
#include "vtkType.h"

#include <string> // for reasons

/**
 * @class   vtkShadowedSceneReport
 * @brief   what vtkShadowedScenePass did in its last picture
 *
 * This is a plain value object. Counts of what was not done are 0: all of them are where a scene
 * has no opaque actor or no light that casts shadows.
 *
 * @sa vtkShadowedScenePass
 */
struct INTERLUMELIGHT_EXPORT vtkShadowedSceneReport
{
  /// The numbers of opaque actors that cast shadows, of lights that they cast them of, and of
  /// volumes that take part.
  int Casters = 0;
  int Lights = 0;
  int Volumes = 0;
  /// The numbers of visible actors that are kept from casting shadows, and from receiving them.
  int NotCasting = 0;
  int NotReceiving = 0;
  /// The number of volumes that share one set of slices, and cast shadows on each other: none, or
  /// two and more. Where others are drawn one by one, with shadows on surfaces alone, VolumesApart
  /// says why, unless they have errors; it is empty otherwise.
  int VolumesTogether = 0;
  std::string VolumesApart;
  /// The number of actors that receive the light which volumes have scattered on and on (those that
  /// are lit), of the cells of all volumes that opaque actors block to it, and of the volumes that
  /// scatter it and do not see that of each other: none, or two and more.
  int ScatteringReceivers = 0;
  int ScatteringBlockedCells = 0;
  int ScatteringVolumesApart = 0;
  /// The number of lights whose colours on actors are those of an image: the screen of a
  /// vtkProjectiveLight, with an image or without, or the emitter of a vtkAreaLight.
  int Images = 0;
  /// The number of depth maps of lights without extent (six for a light amid the actors, else one),
  /// of those drawn for this picture, and the columns and rows of each.
  int DepthMaps = 0;
  int DepthMapsDrawn = 0;
  int DepthMapResolution = 0;
  /// The number of area lights among the lights, of depth maps of their samples (one for each, six
  /// where a sample is amid the actors), of those drawn for this picture, and the columns and rows
  /// of each. These maps are not counted above.
  int AreaLights = 0;
  int SampleMaps = 0;
  int SampleMapsDrawn = 0;
  int SampleMapResolution = 0;
  /// The number of passes that drew the depth that the eye sees, 0 or 1: only volumes need it.
  int EyeDepthPasses = 0;
  /// The numbers of pixels with a surface that no light reaches through a volume, that lies within
  /// the slices of a volume, and that lies behind all of them, in the direction of light: the
  /// regions 1, 2 and 3 of the source's table 2.1, summed over sweeps and volumes.
  vtkIdType PixelsBefore = 0;
  vtkIdType PixelsWithin = 0;
  vtkIdType PixelsBehind = 0;
  /// The number of passes that looked up what light volumes leave at these pixels: one for each
  /// light, and slab with surfaces.
  int ReceiverPasses = 0;
  /// The number of translucent actors that take part, of their layers as lights and as the eye see
  /// them, of the segments between the latter that volumes were drawn in, and the bytes of both.
  int TranslucentActors = 0;
  int LightLayers = 0;
  int EyeLayers = 0;
  int SlicedSegments = 0;
  vtkIdType LightLayerBytes = 0;
  vtkIdType EyeLayerBytes = 0;
  /// The bytes of depth maps, of those of samples, of the eye's depth, and of the light that
  /// volumes leave.
  vtkIdType DepthMapBytes = 0;
  vtkIdType SampleMapBytes = 0;
  vtkIdType EyeDepthBytes = 0;
  vtkIdType TransmittanceBytes = 0;

  void Print(ostream& os, vtkIndent indent) const;
};

#endif
