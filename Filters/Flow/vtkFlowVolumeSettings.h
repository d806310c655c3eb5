// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkFlowVolumeSettings_h
#define vtkFlowVolumeSettings_h

#include "vtkAlgorithm.h" // for the precision

/**
 * @class   vtkFlowVolumeSettings
 * @brief   settings of vtkFlowVolume except intervals and surfaces, with their defaults
 *
 * The filter inherits from this struct, so that VTK's setter macros work and the settings can be
 * passed on together. See the setters of vtkFlowVolume for their meaning.
 *
 * @sa vtkFlowVolume
 */
struct vtkFlowVolumeSettings
{
  double TimeRange[2] = { 0.0, VTK_DOUBLE_MAX };
  double MaximumTimeJump = 0.0;
  bool GenerateStreamSurfaces = false;
  bool GenerateTimeSurfaces = false;
  bool GenerateNormals = false;
  bool ParametersAsTextureCoordinates = false;
  int OutputPointsPrecision = vtkAlgorithm::DEFAULT_PRECISION;
};

#endif
