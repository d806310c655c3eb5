#ifndef vtkShadowedSliceReport_h
#define vtkShadowedSliceReport_h

#include "InterlumeLightModule.h" // for the export macro
#include "vtkIndent.h"
#include "vtkType.h"

#include <string> // for the features

/**
 * @class   vtkShadowedSliceReport
 * @brief   what vtkShadowedSliceMapper did in its last picture
 *
 * A plain value object. Counts of what was not done are 0; strings are empty before the first
 * picture.
 *
 * @sa vtkShadowedSliceMapper
 */
struct INTERLUMELIGHT_EXPORT vtkShadowedSliceReport
{
  /// Lights that shade the volume, and those of them that cast shadows in it.
  int Lights = 0;
  int ShadowedLights = 0;
  /// Sweeps of slices through the volume, and those of them from front to back. Lights on both
  /// sides of the volume, or one inside it, take more than one.
  int Sweeps = 0;
  int FrontToBackSweeps = 0;
  /// Slices over all sweeps, those that meet a block that is not empty, their distance in world
  /// units (that of the first sweep).
  int Slices = 0;
  int SlicesDrawn = 0;
  double SliceSpacing = 0.0;
  /// Passes over the picture's buffer, over light buffers, and to find what is already opaque.
  int EyePasses = 0;
  int LightPasses = 0;
  int OcclusionPasses = 0;
  /// Buffers of the picture, of lights (one for each that casts shadows), and their bytes.
  int ImageBuffers = 0;
  vtkIdType ImageBufferBytes = 0;
  int LightBuffers = 0;
  vtkIdType LightBufferBytes = 0;
  /// Columns and rows of the largest light buffer; channels of light that are attenuated, 1 or 3.
  int LightBufferSize = 0;
  int LightChannels = 0;
  /// Names of the parts of the shaders that were compiled in, separated by spaces. Words of shadows
  /// (`shadow`, ...) stand there only when a light casts them.
  std::string Features;

  /// Blocks of the volume, and those with something to see.
  int Blocks = 0;
  int BlocksDrawn = 0;
  /// Voxels with NaN or infinity, which are transparent.
  vtkIdType NonFiniteVoxels = 0;
  /// Bytes of textures of volume and transfer functions, those sent for this picture, and the
  /// slices' triangles, which are sent for each picture.
  vtkIdType TextureBytes = 0;
  vtkIdType UploadedBytes = 0;
  vtkIdType TriangleBytes = 0;
  /// Pixels of the viewport for each of the picture, along an edge.
  double ImageSampleDistance = 1.0;
  /// Seconds of this picture, until the graphics card was done where the mapper measures that.
  double Seconds = 0.0;

  void Print(ostream& os, vtkIndent indent) const;
};

#endif
