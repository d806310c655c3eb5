// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Measures/BenchTiming.h"
#include "Benchmarks/Results/SpeedPlots.h"
#include "Benchmarks/Suites/BenchParts.h"
#include "Support/Images/CameraSettings.h"
#include "Support/Images/VolumeStage.h"

#include "vtkAnalyticFlowSource.h"
#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkImageData.h"
#include "vtkImplicitFlowField.h"
#include "vtkImplicitFlowVolumeMapper.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkTerminationCylinder.h"
#include "vtkTerminationPlane.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace
{
constexpr int TEXELS = 256;

/// Returns an inflow texture of colored squares, half of them nearly transparent.
vtkSmartPointer<vtkImageData> MakePaint()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(TEXELS, TEXELS, 1);
  image->AllocateScalars(VTK_FLOAT, 4);
  for (int j = 0; j < TEXELS; ++j)
  {
    for (int i = 0; i < TEXELS; ++i)
    {
      const bool isDark = (i / 16 + j / 16) % 2 == 0;
      const double color[4] = { i / 255.0, j / 255.0, 0.5, isDark ? 0.002 : 0.04 };
      for (int c = 0; c < 4; ++c)
      {
        image->SetScalarComponentFromDouble(i, j, 0, c, color[c]);
      }
    }
  }
  return image;
}

/// Returns an implicit flow field with n^3 samples in the cube [-0.8, 0.8]^3.
vtkSmartPointer<vtkImageData> MakeFlow(const std::string& name, int n)
{
  vtkNew<vtkAnalyticFlowSource> source;
  const bool isHurricane = name == "hurricane";
  source->SetField(isHurricane ? vtkAnalyticFlowSource::HURRICANE
      : name == "uniform"      ? vtkAnalyticFlowSource::UNIFORM
                               : vtkAnalyticFlowSource::ROTATION);
  source->SetDimensions(33, 33, 33);
  const double half = isHurricane ? 1.3 : 1.2;
  const double bounds[6] = { -half, half, -half, half, -half, half };
  source->SetBounds(bounds);
  vtkNew<vtkImplicitFlowField> flow;
  flow->SetInputConnection(source->GetOutputPort());
  flow->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_IMAGE);
  flow->SetSampleDimensions(n, n, n);
  const double inner[6] = { -0.8, 0.8, -0.8, 0.8, -0.8, 0.8 };
  flow->SetSampleBounds(inner);
  vtkNew<vtkTerminationPlane> plane;
  vtkNew<vtkTerminationCylinder> cylinder;
  if (name == "uniform")
  {
    flow->DomainFacesOn();
  }
  else if (isHurricane)
  {
    source->SetHeight(2.6);
    cylinder->SetPoint1(0.0, 0.0, -1.3);
    cylinder->SetPoint2(0.0, 0.0, 1.3);
    cylinder->SetRadius(1.25);
    flow->AddTerminationSurface(cylinder);
  }
  else
  {
    plane->SetOrigin(0.0, 0.0, -1.2);
    plane->SetPoint1(1.2, 0.0, -1.2);
    plane->SetPoint2(0.0, 0.0, 1.2);
    flow->AddTerminationSurface(plane);
  }
  flow->SetMaximumTime(100.0);
  flow->Update();
  return vtkImageData::SafeDownCast(flow->GetOutputDataObject(0));
}

/// Returns an image with u, v, time and status as four float components in [0, 1].
vtkSmartPointer<vtkImageData> MakeFourComponents(vtkImageData* flow)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->CopyStructure(flow);
  vtkNew<vtkFloatArray> values;
  values->SetNumberOfComponents(4);
  values->SetNumberOfTuples(flow->GetNumberOfPoints());
  vtkDataArray* parameters = flow->GetPointData()->GetArray("TerminationUV");
  vtkDataArray* times = flow->GetPointData()->GetArray("AdvectionTime");
  vtkDataArray* statuses = flow->GetPointData()->GetArray("FlowStatus");
  const double longest = std::max(times->GetRange()[1], 1e-30);
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    values->SetTuple4(i, parameters->GetComponent(i, 0), parameters->GetComponent(i, 1),
      times->GetComponent(i, 0) / longest, statuses->GetComponent(i, 0) == 0.0 ? 1.0 : 0.0);
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

/// A window with one volume. The camera rotates by half a degree between frames.
struct Frames
{
  Frames(vtkVolumeMapper* mapper, vtkVolumeProperty* property, int pixels)
    : Stage(std::array<int, 2>{ { pixels, pixels } })
  {
    this->Camera = reference::LookAt({ { 0.0, 0.0, 0.0 } }, 1.39, { { -0.5, 0.7, -0.6 } }, false);
    this->Stage.SetVolume(mapper, property);
    this->Stage.SetCamera(this->Camera);
  }

  vtkSmartPointer<vtkObjectBase> Draw()
  {
    this->Camera->Azimuth(0.5);
    this->Stage.Render();
    return nullptr;
  }

  reference::VolumeStage Stage;
  vtkSmartPointer<vtkCamera> Camera;
};

vtkSmartPointer<vtkVolumeProperty> MakeProperty(double unit, bool isIndependent)
{
  auto property = vtkSmartPointer<vtkVolumeProperty>::New();
  property->SetIndependentComponents(isIndependent);
  property->SetInterpolationTypeToLinear();
  for (int i = 0; i < 4; ++i)
  {
    vtkNew<vtkPiecewiseFunction> opacity;
    opacity->AddPoint(0.0, 0.0);
    opacity->AddPoint(1.0, isIndependent ? 0.01 : 0.02);
    property->SetScalarOpacity(i, opacity);
    property->SetScalarOpacityUnitDistance(i, unit);
  }
  return property;
}

vtkSmartPointer<vtkImplicitFlowVolumeMapper> NewMapper(vtkImageData* flow, vtkImageData* paint)
{
  auto mapper = vtkSmartPointer<vtkImplicitFlowVolumeMapper>::New();
  mapper->SetInputData(static_cast<vtkDataSet*>(flow));
  mapper->SetInflowTexture(vtkImplicitFlowVolumeMapper::ALL, paint);
  return mapper;
}

vtkSmartPointer<vtkGPUVolumeRayCastMapper> NewRayCaster(vtkImageData* image, double distance)
{
  auto mapper = vtkSmartPointer<vtkGPUVolumeRayCastMapper>::New();
  mapper->SetInputData(image);
  mapper->SetBlendModeToComposite();
  mapper->UseJitteringOff();
  mapper->AutoAdjustSampleDistancesOff();
  mapper->SetSampleDistance(static_cast<float>(distance));
  return mapper;
}

BenchRow MakeRow(const BenchRows& rows, const std::string& name, const char* method, int n,
  const BenchSeconds& seconds, const char* baseline, const BenchSeconds& baselineSeconds)
{
  BenchRow row = rows.Make(name, method, n);
  row.SetTimes(seconds, baseline, baselineSeconds);
  row.Set({ { "processor_seconds", seconds.Processor },
    { "peer_processor_seconds", baselineSeconds.Processor } });
  return row;
}

void AddRows(
  const std::string& name, int n, int pixels, const BenchOptions& options, BenchRows& rows)
{
  const vtkSmartPointer<vtkImageData> flow = MakeFlow(name, n);
  const vtkSmartPointer<vtkImageData> four = MakeFourComponents(flow);
  const double voxel = flow->GetSpacing()[0];
  const vtkSmartPointer<vtkImageData> paint = MakePaint();
  std::vector<std::unique_ptr<Frames>> frames;
  std::vector<BenchWork> works;
  const auto add = [&](vtkVolumeMapper* mapper, bool isIndependent)
  {
    frames.push_back(std::make_unique<Frames>(mapper, MakeProperty(voxel, isIndependent), pixels));
    works.push_back([draw = frames.back().get()] { return draw->Draw(); });
  };
  std::vector<vtkSmartPointer<vtkImplicitFlowVolumeMapper>> mappers;
  for (const bool isFiltered : { true, false })
  {
    mappers.push_back(NewMapper(flow, paint));
    mappers.back()->SetSampleDistance(0.5 * voxel);
    mappers.back()->SetTextureFilter(isFiltered);
    add(mappers.back(), true);
  }
  for (const bool isIndependent : { true, false })
  {
    add(NewRayCaster(four, 0.5 * voxel), isIndependent);
  }
  const std::vector<BenchSeconds> seconds = MeasureAlternately(works, options.GetRepeats());
  const char* methods[] = { "textures", "textures, unfiltered" };
  const char* baselines[] = { "gpu", "gpu-rgba" };
  for (std::size_t method = 0; method < 2; ++method)
  {
    for (std::size_t baseline = 0; baseline < 2; ++baseline)
    {
      BenchRow row = MakeRow(rows, name, methods[method], n, seconds[method], baselines[baseline],
        seconds[2 + baseline]);
      vtkInterlumeReport* report = mappers[method]->GetReport();
      row.Set({ { "texture_bytes", report->GetCount("TextureBytes") },
        { "split_cells", report->GetCount("SplitCells") }, { "pixels", pixels } });
      rows.Add(row);
    }
  }
}

/// Measures the cost of shadows, with a fixed light and with a moving light.
void AddShadowRows(int n, int pixels, const BenchOptions& options, BenchRows& rows)
{
  const vtkSmartPointer<vtkImageData> flow = MakeFlow("rotation", n);
  const vtkSmartPointer<vtkImageData> paint = MakePaint();
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  std::array<std::unique_ptr<Frames>, 3> frames;
  std::array<vtkSmartPointer<vtkImplicitFlowVolumeMapper>, 3> mappers;
  std::vector<BenchWork> works;
  for (std::size_t i = 0; i < frames.size(); ++i)
  {
    mappers[i] = NewMapper(flow, paint);
    mappers[i]->SetShadows(i > 0);
    frames[i] =
      std::make_unique<Frames>(mappers[i], MakeProperty(flow->GetSpacing()[0], true), pixels);
    frames[i]->Stage.SetLights({ light.Get() });
    works.push_back(
      [draw = frames[i].get(), light = light.Get(), isMoving = i == 2, angle = 0.0]() mutable
      {
        angle += isMoving ? 0.02 : 0.0;
        light->SetPosition(std::sin(angle), -2.0, 0.5);
        return draw->Draw();
      });
  }
  const std::vector<BenchSeconds> seconds = MeasureAlternately(works, options.GetRepeats());
  const char* names[] = { "no shadows", "shadows", "shadows, light moving" };
  for (std::size_t i = 1; i < frames.size(); ++i)
  {
    BenchRow row = MakeRow(rows, "rotation", names[i], n, seconds[i], names[i - 1], seconds[i - 1]);
    vtkInterlumeReport* report = mappers[i]->GetReport();
    row.Set({ { "slices", report->GetCount("Slices") },
      { "light_buffer_size", report->GetCount("LightBufferSize") }, { "pixels", pixels } });
    rows.Add(row);
  }
}

void AddAllRows(const BenchOptions& options, BenchRows& rows)
{
  for (const char* name : { "uniform", "rotation", "hurricane" })
  {
    AddRows(name, options.Pick(128, 48, 12), options.Pick(512, 192, 32), options, rows);
  }
  AddShadowRows(options.Pick(64, 32, 12), options.Pick(256, 128, 32), options, rows);
}

std::vector<BenchClaim> CheckClaims(const std::vector<BenchRow>& rows)
{
  const auto ratioTo = [](const std::string& baseline, bool onlyFiltered)
  {
    return [=](const BenchRow& row) -> std::optional<double>
    {
      const bool concerned =
        row.Baseline == baseline && (!onlyFiltered || row.Method == "textures");
      return concerned ? row.GetRatio() : std::nullopt;
    };
  };
  return {
    BenchClaim::AtLeast("no slower than gpu, textures filtered", 1.0, rows, ratioTo("gpu", true)),
    BenchClaim::AtLeast(
      "no slower than gpu-rgba, filtered and unfiltered", 1.0, rows, ratioTo("gpu-rgba", false)),
  };
}

std::vector<BenchPlot> MakePlots(const std::vector<BenchRow>& rows)
{
  return MakeRatioPlots("flow-texture", "textures", rows);
}
}

BenchPart MakeFlowTexturePart()
{
  return { AddAllRows, MakePlots, CheckClaims };
}
