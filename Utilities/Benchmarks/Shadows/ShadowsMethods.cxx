// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Shadows/ShadowsMethods.h"

#include "Benchmarks/Shadows/GpuShadows.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkRenderer.h"
#include "vtkVolumeCollection.h"
#include "vtkVolumeProperty.h"

#include <algorithm>

namespace shadows
{
namespace
{
vtkSmartPointer<vtkGPUVolumeRayCastMapper> NewRayCaster(
  const reference::ShadowScene& scene, double sampleDistance)
{
  const double* spacing = scene.Image->GetSpacing();
  auto mapper = vtkSmartPointer<vtkGPUVolumeRayCastMapper>::New();
  mapper->SetInputData(scene.Image.Get());
  mapper->AutoAdjustSampleDistancesOff();
  mapper->SetImageSampleDistance(1.0f);
  mapper->SetSampleDistance(
    static_cast<float>(sampleDistance * std::min({ spacing[0], spacing[1], spacing[2] })));
  return mapper;
}
}

const char* const GpuBaseline = "gpu";
const char* const GpuShadowsBaseline = "gpu-shadows";

Method::Method(
  reference::VolumeStage& stage, const reference::ShadowScene& scene, vtkVolumeMapper* mapper)
  : Stage(stage)
  , Scene(scene)
  , Mapper(mapper)
{
  this->Volume->SetMapper(mapper);
  this->Volume->SetProperty(scene.Property);
  stage.GetVolume()->VisibilityOff();
  stage.GetRenderer()->AddVolume(this->Volume);
}

Method::~Method()
{
  this->Stage.GetRenderer()->RemoveVolume(this->Volume);
}

void Method::Show(vtkCamera* camera)
{
  vtkVolumeCollection* volumes = this->Stage.GetRenderer()->GetVolumes();
  vtkCollectionSimpleIterator at;
  volumes->InitTraversal(at);
  while (vtkVolume* volume = volumes->GetNextVolume(at))
  {
    volume->SetVisibility(volume == this->Volume.Get());
  }
  this->Stage.SetLights(this->Scene.Lights);
  this->Stage.SetCamera(camera);
}

BenchWork Method::GetFrame(int threads)
{
  return WithThreads(threads,
    [this]()
    {
      vtkNew<vtkCamera> moved;
      moved->DeepCopy(this->Scene.Camera);
      moved->Azimuth(0.5 * (++this->Frames % 40));
      this->Show(moved);
      this->Stage.Render();
      return vtkSmartPointer<vtkObjectBase>(this->Mapper);
    });
}

reference::RgbaImage Method::Capture()
{
  this->Show(this->Scene.Camera);
  if (this->GetSliceMapper())
  {
    return this->Stage.Capture();
  }
  // vtkGPUVolumeRayCastMapper cannot read the depth buffer of the floating-point framebuffer, and
  // renders nothing to it unless the mapper has read another depth buffer before.
  this->Stage.Render();
  return this->Stage.Capture(2);
}

vtkShadowedSliceMapper* Method::GetSliceMapper()
{
  return vtkShadowedSliceMapper::SafeDownCast(this->Mapper);
}

MethodPointer MakeSliceMethod(reference::VolumeStage& stage, const reference::ShadowScene& scene,
  const std::function<void(vtkShadowedSliceMapper*)>& set)
{
  vtkNew<vtkShadowedSliceMapper> mapper;
  mapper->SetInputData(scene.Image.Get());
  mapper->AutoAdjustSampleDistancesOff();
  mapper->SetShadows(scene.Shadows);
  if (set)
  {
    set(mapper);
  }
  return std::make_unique<Method>(stage, scene, mapper);
}

MethodPointer MakeRayCastMethod(
  reference::VolumeStage& stage, const reference::ShadowScene& scene, double sampleDistance)
{
  return std::make_unique<Method>(stage, scene, NewRayCaster(scene, sampleDistance));
}

MethodPointer MakeShadowRayMethod(
  reference::VolumeStage& stage, const reference::ShadowScene& scene, double sampleDistance)
{
  if (!HasGpuShadows())
  {
    return nullptr;
  }
  auto mapper = NewRayCaster(scene, sampleDistance);
  EnableGpuShadows(mapper);
  reference::ShadowScene shaded = scene;
  shaded.Property = vtkSmartPointer<vtkVolumeProperty>::New();
  shaded.Property->DeepCopy(scene.Property);
  shaded.Property->ShadeOn();
  return std::make_unique<Method>(stage, shaded, mapper);
}

void MeasureFrames(std::vector<Setting>& settings, int threads, int repeats)
{
  std::vector<BenchWork> works;
  for (const Setting& setting : settings)
  {
    works.push_back(setting.Drawn->GetFrame(threads));
  }
  const std::vector<BenchSeconds> seconds = MeasureAlternately(works, repeats);
  for (std::size_t i = 0; i < settings.size(); ++i)
  {
    settings[i].Seconds = seconds[i];
  }
}

void AddReport(vtkInterlumeReport* report, BenchRow& row)
{
  using Name = std::pair<const char*, const char*>;
  for (const auto& [count, value] :
    { Name("lights", "Lights"), Name("shadowed_lights", "ShadowedLights"), Name("sweeps", "Sweeps"),
      Name("slices", "SlicesDrawn"), Name("eye_passes", "ImagePasses"),
      Name("light_passes", "LightPasses"), Name("light_buffers", "LightBuffers"),
      Name("light_buffer_size", "LightBufferSize"), Name("light_buffer_bytes", "LightBufferBytes"),
      Name("image_buffer_bytes", "ImageBufferBytes"), Name("texture_bytes", "TextureBytes"),
      Name("blocks", "Blocks"), Name("blocks_drawn", "BlocksDrawn") })
  {
    row.Counts[count] = report->GetCount(value);
  }
}
}
