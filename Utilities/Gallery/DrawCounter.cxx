// SPDX-License-Identifier: BSD-3-Clause
#include "Gallery/DrawCounter.h"

#include "Gallery/Panel.h"
#include "Gallery/SceneReport.h"

#include "vtkActor.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkPropCollection.h"
#include "vtkShadowedScenePass.h"
#include "vtkImplicitFlowVolumeMapper.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkTimeWeightedTetrahedraMapper.h"
#include "vtkVolumeCollection.h"

#include <algorithm>

namespace gallery
{
struct DrawCounter::Counted
{
  vtkSmartPointer<vtkObject> Mapper;
  int Draws = 0;
  unsigned long Tag = 0;
};

DrawCounter::DrawCounter(vtkRenderer* renderer)
{
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator cookie;
  props->InitTraversal(cookie);
  while (vtkProp* prop = props->GetNextProp(cookie))
  {
    vtkActor* actor = vtkActor::SafeDownCast(prop);
    vtkMapper* mapper = actor ? actor->GetMapper() : nullptr;
    if (!mapper)
    {
      continue;
    }
    this->Counts.push_back(std::make_unique<Counted>());
    Counted* counted = this->Counts.back().get();
    counted->Mapper = mapper;
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(counted);
    command->SetCallback(
      [](vtkObject*, unsigned long, void* data, void*) { ++static_cast<Counted*>(data)->Draws; });
    counted->Tag = mapper->AddObserver(vtkCommand::StartEvent, command);
  }
}

DrawCounter::~DrawCounter()
{
  for (const std::unique_ptr<Counted>& counted : this->Counts)
  {
    counted->Mapper->RemoveObserver(counted->Tag);
  }
}

int DrawCounter::GetPasses() const
{
  int passes = 0;
  for (const std::unique_ptr<Counted>& counted : this->Counts)
  {
    passes = std::max(passes, counted->Draws);
  }
  return passes;
}

BufferCount CountBuffers(const Panel& panel, std::set<std::string>& features)
{
  BufferCount count;
  const vtkIdType pixels = panel.GetNumberOfPixels();
  // The color (RGBA8) and depth textures of the window, and the textures into which they are
  // resolved.
  count.Buffers = 4;
  count.Bytes = 16 * pixels;
  if (panel.UsesAmbientOcclusion())
  {
    features.insert("ambient-occlusion");
    // Textures of vtkSSAOPass: color RGBA32F, position and normal RGB16F, occlusion R8, depth 32F.
    // Its two screen-space passes compute the occlusion and combine it with the color.
    count.Buffers += 5;
    count.Bytes += (16 + 6 + 6 + 1 + 4) * pixels;
    count.ScreenPasses += 2;
  }
  if (auto* scene = vtkShadowedScenePass::SafeDownCast(panel.GetRenderer()->GetPass()))
  {
    features.insert("scene-shadows");
    for (const char* name : { "DepthMapBytes", "CameraDepthBytes", "TransmittanceBytes" })
    {
      const double bytes = scene->GetReport()->GetNumber(name);
      count.Buffers += bytes > 0 ? 1 : 0;
      count.Bytes += bytes;
    }
  }
  return count;
}

void AddVolumeReports(const Panel& panel, SceneReport& report)
{
  vtkVolumeCollection* volumes = panel.GetRenderer()->GetVolumes();
  vtkCollectionSimpleIterator cookie;
  volumes->InitTraversal(cookie);
  while (vtkVolume* volume = volumes->GetNextVolume(cookie))
  {
    if (auto* sliced = vtkShadowedSliceMapper::SafeDownCast(volume->GetMapper()))
    {
      report.AddSlicedVolume(sliced->GetReport());
    }
    else if (auto* inflow = vtkImplicitFlowVolumeMapper::SafeDownCast(volume->GetMapper()))
    {
      report.AddInflowVolume(inflow->GetReport());
    }
    else if (auto* mapper = vtkTimeWeightedTetrahedraMapper::SafeDownCast(volume->GetMapper()))
    {
      report.AddVolume(mapper->GetReport());
    }
  }
}
}
