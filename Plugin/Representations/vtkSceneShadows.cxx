// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSceneShadows.h"

#include "vtkDrawingPass.h"
#include "vtkShadowedScenePass.h"
#include "vtkShadowedSliceMapper.h"

#include "vtkCommand.h"
#include "vtkObjectFactory.h"
#include "vtkPVDefaultPass.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>

vtkStandardNewMacro(vtkSceneShadows);

namespace
{
/// Returns all existing vtkSceneShadows by their renderers.
std::map<vtkRenderer*, vtkSceneShadows*>& GetAll()
{
  static std::map<vtkRenderer*, vtkSceneShadows*> all;
  return all;
}
}

vtkSceneShadows::vtkSceneShadows() = default;

vtkSmartPointer<vtkSceneShadows> vtkSceneShadows::GetOrCreate(vtkRenderer* renderer)
{
  const auto entry = GetAll().find(renderer);
  if (entry != GetAll().end())
  {
    return entry->second;
  }
  auto shadows = vtkSmartPointer<vtkSceneShadows>::New();
  shadows->Renderer = renderer;
  shadows->Observers[0] =
    renderer->AddObserver(vtkCommand::StartEvent, shadows.Get(), &vtkSceneShadows::UpdatePass);
  shadows->Observers[1] =
    renderer->AddObserver(vtkCommand::EndEvent, shadows.Get(), &vtkSceneShadows::RestoreLights);
  GetAll()[renderer] = shadows;
  return shadows;
}

vtkSceneShadows::~vtkSceneShadows()
{
  const auto isThis = [this](const auto& entry) { return entry.second == this; };
  const auto entry = std::find_if(GetAll().begin(), GetAll().end(), isThis);
  if (entry != GetAll().end())
  {
    GetAll().erase(entry);
  }
  if (this->Renderer)
  {
    for (const unsigned long observer : this->Observers)
    {
      this->Renderer->RemoveObserver(observer);
    }
    this->Requests.clear();
    this->UpdatePass();
    this->RestoreLights();
  }
}

void vtkSceneShadows::SetRequest(const void* requester, const Request& request)
{
  this->Requests[requester] = request;
}

void vtkSceneShadows::RemoveRequest(const void* requester)
{
  this->Requests.erase(requester);
}

void vtkSceneShadows::UpdatePass()
{
  Request combined;
  int lightLimit = 0;
  for (const auto& entry : this->Requests)
  {
    const Request& request = entry.second;
    lightLimit = std::max(lightLimit, request.Mapper->GetMaximumNumberOfShadowLights());
    combined.DepthMapResolution = std::max(combined.DepthMapResolution, request.DepthMapResolution);
    combined.DepthBias = std::max(combined.DepthBias, request.DepthBias);
    combined.HasShadows = combined.HasShadows || request.HasShadows;
    combined.LightAngle = std::max(combined.LightAngle, request.LightAngle);
    combined.LightScale = std::min(combined.LightScale, request.LightScale);
  }
  this->RestoreLights();
  if (combined.LightAngle > 0.0 || combined.LightScale < 1.0)
  {
    this->Lights.Begin(this->Renderer, combined.LightAngle, combined.LightScale);
  }
  this->Pass->SetMaximumNumberOfShadowLights(lightLimit);
  this->Pass->SetDepthMapResolution(combined.DepthMapResolution);
  this->Pass->SetDepthBias(combined.DepthBias);
  vtkDrawingPass drawingPass(this->Renderer);
  const bool isInstalled = drawingPass.Get() == this->Pass.Get();
  if (combined.HasShadows && vtkPVDefaultPass::SafeDownCast(drawingPass.Get()))
  {
    this->Pass->SetDelegatePass(drawingPass.Get());
    drawingPass.Set(this->Pass);
  }
  if (!combined.HasShadows && isInstalled)
  {
    if (vtkRenderWindow* window = this->Renderer->GetRenderWindow())
    {
      this->Pass->ReleaseGraphicsResources(window);
    }
    drawingPass.Set(this->Pass->GetDelegatePass());
    this->Pass->SetDelegatePass(nullptr);
  }
}

void vtkSceneShadows::RestoreLights()
{
  this->Lights.End(this->Renderer);
}

void vtkSceneShadows::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Requests: " << this->Requests.size() << "\n";
  os << indent << "Pass:\n";
  this->Pass->PrintSelf(os, indent.GetNextIndent());
}
