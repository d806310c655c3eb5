// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkFlowVolumeSettings_h
#define vtkFlowVolumeSettings_h

#include "vtkAlgorithm.h" // for the precision

/**
 * @class   vtkFlowVolumeSettings
 * @brief   what vtkFlowVolume can be told besides intervals and surfaces, with its defaults
 *
 * The filter is made of them, so that VTK's macros for setters serve them, and hands them on as a
 * whole. Each is documented at its setter there.
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
