// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkImplicitFlowVolumeSettings_h
#define vtkImplicitFlowVolumeSettings_h

#include "vtkImageData.h"         // for textures
#include "vtkPiecewiseFunction.h" // for the gate
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <map>    // for textures by id
#include <string> // for names of arrays

/**
 * @class   vtkImplicitFlowVolumeSettings
 * @brief   what vtkImplicitFlowVolumeMapper is set to
 *
 * The mapper's header documents each value.
 */
struct vtkImplicitFlowVolumeSettings
{
  enum DetailModes
  {
    DETAIL_MODULATE = 0,
    DETAIL_OVER = 1,
    DETAIL_ADD = 2
  };
  enum TimeGateTargets
  {
    GATE_INFLOW = 0,
    GATE_DETAIL = 1,
    GATE_BOTH = 2
  };

  std::map<int, vtkSmartPointer<vtkImageData>> InflowTextures;
  double DefaultColor[4] = { 0.8, 0.8, 0.8, 0.05 };

  vtkSmartPointer<vtkImageData> DetailTexture;
  int DetailMode = DETAIL_MODULATE;
  double DetailScale[3] = { 1.0, 1.0, 1.0 };

  vtkSmartPointer<vtkPiecewiseFunction> TimeGate;
  int TimeGateTarget = GATE_INFLOW;
  bool TimeGateRepeat = true;
  double TimePeriod = 1.0;
  double TimePhase = 0.0;

  std::string OpacityArray;
  std::string ShadingArray;

  bool Shadows = false;
  int LightBufferSize = 0;

  bool PaintFilter = true;
  int MaximumPaintSamples = 8;
  double SampleDistance = 0.0;
  double ImageSampleDistance = 1.0;
  vtkIdType MaximumTextureMemory = 0;
};

#endif
