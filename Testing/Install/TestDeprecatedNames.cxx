// SPDX-License-Identifier: BSD-3-Clause
// Tests that the names of settings in the previous release still compile and set the same value.
#include "vtkAnalyticFieldSource.h"
#include "vtkFlowStatus.h"
#include "vtkImplicitFlowField.h"
#include "vtkImplicitFlowVolumeMapper.h"
#include "vtkIntervalVolume.h"
#include "vtkNew.h"
#include "vtkShadowedScenePass.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkTerminationSphere.h"

#include <cstdlib>
#include <iostream>
#include <string>

#if defined(__GNUC__)
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"
#endif

namespace
{
int failures = 0;

void Check(bool condition, const char* what)
{
  if (!condition)
  {
    std::cerr << "FAILED " << what << "\n";
    ++failures;
  }
}
}

int main()
{
  vtkNew<vtkIntervalVolume> interval;
  interval->KeepWholeCellsOn();
  interval->SetKeepOrigins(true);
  interval->KeepMemoryOff();
  Check(interval->GetKeepInteriorCells() && interval->GetKeepWholeCells(), "KeepWholeCells");
  Check(interval->GetGenerateOriginArrays(), "KeepOrigins");
  Check(!interval->GetReuseMemory() && !interval->GetKeepMemory(), "KeepMemory");

  vtkNew<vtkImplicitFlowField> field;
  field->ShareStreamlinesOn();
  field->SetKeepSteps(true);
  Check(field->GetInterpolateStreamlines(), "ShareStreamlines");
  Check(field->GetStoreStepCounts(), "KeepSteps");

  vtkNew<vtkImplicitFlowVolumeMapper> textures;
  textures->PaintFilterOff();
  textures->SetMaximumPaintSamples(3);
  Check(!textures->GetTextureFilter(), "PaintFilter");
  Check(textures->GetMaximumTextureSamples() == 3, "MaximumPaintSamples");

  vtkNew<vtkShadowedSliceMapper> slices;
  slices->SetMultipleScatteringToForward();
  slices->SetMaximumNumberOfShadows(2);
  slices->SetLightLookup(vtkShadowedSliceMapper::NEAREST_LIGHT);
  Check(slices->GetScatteringMode() == vtkShadowedSliceMapper::FORWARD_SCATTERING,
    "MultipleScattering");
  Check(slices->GetMaximumNumberOfShadowLights() == 2, "MaximumNumberOfShadows");
  Check(slices->GetLightLookup() == vtkShadowedSliceMapper::NEAREST_LOOKUP, "NEAREST_LIGHT");
  slices->SetMatter(nullptr);

  vtkNew<vtkShadowedScenePass> pass;
  pass->SetMaximumNumberOfShadows(5);
  Check(pass->GetMaximumNumberOfShadowLights() == 5, "MaximumNumberOfShadows of a pass");

  vtkNew<vtkAnalyticFieldSource> source;
  source->SetFieldToBall();
  Check(source->GetField() == vtkAnalyticFieldSource::SPHERE_DISTANCE, "BALL");

  vtkNew<vtkTerminationSphere> sphere;
  const double x[3] = { 1.0, 2.0, 3.0 };
  Check(sphere->IsBeside(x) == sphere->ProjectsOntoSurface(x), "IsBeside");
  Check(sphere->PlaceIn(nullptr, nullptr, true).empty(), "PlaceIn");
  Check(vtkFlowStatus::TOWARDS == vtkFlowStatus::TOWARD &&
      std::string(vtkFlowStatus::BeyondPrefix()) == vtkFlowStatus::FarSidePrefix(),
    "vtkFlowStatus");
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
