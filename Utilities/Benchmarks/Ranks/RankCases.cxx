// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Ranks/RankCases.h"

#include "vtkAnalyticFlowSource.h"
#include "vtkImplicitFlowField.h"
#include "vtkIntervalVolume.h"

#include "vtkFloatArray.h"
#include "vtkImageAlgorithm.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkRTAnalyticSource.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <cmath>

namespace ranks
{
namespace
{
constexpr double Period = 6.283185307179586;

class WaveSource : public vtkImageAlgorithm
{
public:
  static WaveSource* New();
  vtkTypeMacro(WaveSource, vtkImageAlgorithm);

  int Cells = 96;
  int Periods = 1;

protected:
  WaveSource() { this->SetNumberOfInputPorts(0); }

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    vtkInformation* info = outputs->GetInformationObject(0);
    const int extent[6] = { 0, this->Cells * this->Periods, 0, this->Cells, 0, this->Cells };
    info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
    info->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
    return 1;
  }

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    vtkInformation* info = outputs->GetInformationObject(0);
    vtkImageData* image = vtkImageData::GetData(info);
    int extent[6];
    info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent);
    image->SetExtent(extent);
    vtkNew<vtkFloatArray> wave;
    wave->SetName("Wave");
    wave->SetNumberOfValues(image->GetNumberOfPoints());
    vtkIdType id = 0;
    const auto at = [this](int i) { return std::sin(Period * i / this->Cells); };
    for (int k = extent[4]; k <= extent[5]; ++k)
    {
      for (int j = extent[2]; j <= extent[3]; ++j)
      {
        for (int i = extent[0]; i <= extent[1]; ++i)
        {
          wave->SetValue(id++, static_cast<float>(at(i) * at(j) + at(j) * at(k) + at(k) * at(i)));
        }
      }
    }
    image->GetPointData()->SetScalars(wave);
    return 1;
  }
};
vtkStandardNewMacro(WaveSource);
}

vtkSmartPointer<vtkIntervalVolume> MakeVolume(int cells, int periods)
{
  vtkNew<WaveSource> source;
  source->Cells = cells;
  source->Periods = periods;
  auto volume = vtkSmartPointer<vtkIntervalVolume>::New();
  volume->SetInputConnection(source->GetOutputPort());
  volume->SetInterval(0, 0.3, 0.7);
  volume->SetUseValueIndex(false);
  volume->UpdateInformation();
  return volume;
}

vtkSmartPointer<vtkImplicitFlowField> MakeFlow(int points, int periods, int samples)
{
  vtkNew<vtkAnalyticFlowSource> source;
  source->SetField(vtkAnalyticFlowSource::ABC);
  source->SetOutputScalarType(VTK_FLOAT);
  source->SetDimensions(points * periods, points, points);
  source->SetBounds(0.0, Period * periods, 0.0, Period, 0.0, Period);
  auto filter = vtkSmartPointer<vtkImplicitFlowField>::New();
  filter->SetInputConnection(source->GetOutputPort());
  filter->SetDomainFaces(true);
  filter->SetMaximumTime(2.0);
  filter->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_IMAGE);
  filter->SetSampleDimensions(samples * periods, samples, samples);
  filter->UpdateInformation();
  return filter;
}
}
