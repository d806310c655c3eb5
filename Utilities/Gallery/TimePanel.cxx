// SPDX-License-Identifier: BSD-3-Clause
#include "Gallery/TimePanel.h"

#include "Gallery/Look.h"
#include "Gallery/Stage.h"
#include "Gallery/Volumes.h"

#include "vtkAlgorithm.h"
#include "vtkColorTransferFunction.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTimeVaryingIntervalVolume.h"
#include "vtkTimeWeightedTetrahedraMapper.h"
#include "vtkVolumeProperty.h"

namespace gallery
{
std::vector<double> GetTimeSteps(vtkAlgorithm* source)
{
  source->UpdateInformation();
  vtkInformation* information = source->GetOutputInformation(0);
  const double* times = information->Get(vtkStreamingDemandDrivenPipeline::TIME_STEPS());
  return { times, times + information->Length(vtkStreamingDemandDrivenPipeline::TIME_STEPS()) };
}

void BalanceColors(vtkColorTransferFunction* colors)
{
  for (int i = 0; i < colors->GetSize(); ++i)
  {
    double node[6];
    colors->GetNodeValue(i, node);
    node[2] *= 0.5;
    colors->SetNodeValue(i, node);
  }
}

Panel& AddTimePanel(
  Stage& stage, vtkAlgorithm* source, double lower, double upper, double extinction)
{
  vtkNew<vtkTimeVaryingIntervalVolume> interval;
  interval->SetInterval(0, lower, upper);
  vtkSmartPointer<vtkUnstructuredGrid> tetrahedra = stage.Extract(interval, source);
  const std::vector<double> times = GetTimeSteps(source);
  vtkSmartPointer<vtkVolume> volume = MakeTimeColoredVolume(tetrahedra, times, extinction);
  BalanceColors(volume->GetProperty()->GetRGBTransferFunction());
  GetMapper(volume)->SetBlendModeToAdditive();

  Panel& panel = stage.AddPanel("");
  panel.SetBackground(DarkBackground());
  panel.Add(volume);
  stage.SetColorBar(
    "time", volume->GetProperty()->GetRGBTransferFunction(), times.front(), times.back());
  return panel;
}
}
