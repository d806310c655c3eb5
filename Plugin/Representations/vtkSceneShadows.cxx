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
/// The one of each renderer that somebody holds one of.
std::map<vtkRenderer*, vtkSceneShadows*>& GetAll()
{
  static std::map<vtkRenderer*, vtkSceneShadows*> all;
  return all;
}
}

vtkSceneShadows::vtkSceneShadows() = default;

vtkSmartPointer<vtkSceneShadows> vtkSceneShadows::For(vtkRenderer* renderer)
{
  const auto known = GetAll().find(renderer);
  if (known != GetAll().end())
  {
    return known->second;
  }
  auto shadows = vtkSmartPointer<vtkSceneShadows>::New();
  shadows->Renderer = renderer;
  shadows->Observers[0] =
    renderer->AddObserver(vtkCommand::StartEvent, shadows.Get(), &vtkSceneShadows::Arrange);
  shadows->Observers[1] =
    renderer->AddObserver(vtkCommand::EndEvent, shadows.Get(), &vtkSceneShadows::Finish);
  GetAll()[renderer] = shadows;
  return shadows;
}

vtkSceneShadows::~vtkSceneShadows()
{
  const auto isThis = [this](const auto& entry) { return entry.second == this; };
  const auto known = std::find_if(GetAll().begin(), GetAll().end(), isThis);
  if (known != GetAll().end())
  {
    GetAll().erase(known);
  }
  if (this->Renderer)
  {
    for (const unsigned long observer : this->Observers)
    {
      this->Renderer->RemoveObserver(observer);
    }
    this->Wishes.clear();
    this->Arrange();
    this->Finish();
  }
}

void vtkSceneShadows::SetWish(const void* owner, const Wish& wish)
{
  this->Wishes[owner] = wish;
}

void vtkSceneShadows::RemoveWish(const void* owner)
{
  this->Wishes.erase(owner);
}

void vtkSceneShadows::Arrange()
{
  Wish most;
  int number = 0;
  for (const auto& entry : this->Wishes)
  {
    const Wish& wish = entry.second;
    number = std::max(number, wish.Mapper->GetMaximumNumberOfShadows());
    most.DepthMapResolution = std::max(most.DepthMapResolution, wish.DepthMapResolution);
    most.DepthBias = std::max(most.DepthBias, wish.DepthBias);
    most.HasShadows = most.HasShadows || wish.HasShadows;
    most.LightAngle = std::max(most.LightAngle, wish.LightAngle);
  }
  this->Finish();
  if (most.LightAngle > 0.0)
  {
    this->Lights.Begin(this->Renderer, most.LightAngle);
  }
  this->Pass->SetMaximumNumberOfShadows(number);
  this->Pass->SetDepthMapResolution(most.DepthMapResolution);
  this->Pass->SetDepthBias(most.DepthBias);
  vtkDrawingPass place(this->Renderer);
  const bool isThere = place.Get() == this->Pass.Get();
  if (most.HasShadows && vtkPVDefaultPass::SafeDownCast(place.Get()))
  {
    this->Pass->SetDelegatePass(place.Get());
    place.Set(this->Pass);
  }
  if (!most.HasShadows && isThere)
  {
    if (vtkRenderWindow* window = this->Renderer->GetRenderWindow())
    {
      this->Pass->ReleaseGraphicsResources(window);
    }
    place.Set(this->Pass->GetDelegatePass());
    this->Pass->SetDelegatePass(nullptr);
  }
}

void vtkSceneShadows::Finish()
{
  this->Lights.End(this->Renderer);
}

void vtkSceneShadows::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Wishes: " << this->Wishes.size() << "\n";
  os << indent << "Pass:\n";
  this->Pass->PrintSelf(os, indent.GetNextIndent());
}
