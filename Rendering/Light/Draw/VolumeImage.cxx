// SPDX-License-Identifier: BSD-3-Clause
#include "Draw/VolumeImage.h"

#include "Receivers/SliceScene.h"

#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

namespace interlume
{

void VolumeImage::Begin(const VolumeResources::Request& request, const Error& error)
{
  this->Volume.SetRequest(request, error);
  this->Together.reset();
  this->Scene = nullptr;
}

void VolumeImage::Draw(vtkRenderer* renderer, SliceScene* scene)
{
  this->Scene = scene;
  if (!this->HasContents())
  {
    return;
  }
  std::vector<VolumeResources*> volumes;
  if (this->IsValid())
  {
    volumes.push_back(&this->Volume);
  }
  const Error drawn = this->OwnRenderer.Draw(renderer, volumes, scene);
  Error& error = this->Volume.GetResult().Error;
  error = error ? error : drawn;
}

Error VolumeImage::DrawTogether(vtkRenderer* renderer, const std::vector<VolumeImage*>& images,
  const std::shared_ptr<SliceRenderer>& together, SliceScene& scene)
{
  std::vector<VolumeResources*> volumes;
  for (VolumeImage* image : images)
  {
    if (image->IsValid())
    {
      volumes.push_back(&image->Volume);
    }
  }
  if (volumes.size() < 2)
  {
    return {};
  }
  Error error = together->Draw(renderer, volumes, &scene);
  for (VolumeImage* image : images)
  {
    if (!error && image->IsValid())
    {
      image->Together = together;
      image->Scene = &scene;
      image->OwnRenderer.ReleaseGraphicsResources(renderer->GetRenderWindow());
    }
  }
  return error;
}

void VolumeImage::End()
{
  this->Scene = nullptr;
  this->GetReport().CopyTo(this->GetRequest().Report);
}

void VolumeImage::Show(vtkRenderer* renderer)
{
  if (this->Scene && this->Scene->Show)
  {
    this->Scene->Show();
    return;
  }
  this->GetRenderer().Show(renderer);
}

bool VolumeImage::ReadLightBuffer(vtkRenderer* renderer, vtkLight* light, vtkImageData* image)
{
  return this->GetRenderer().ReadLightBuffer(renderer, light, image);
}

void VolumeImage::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Volume.ReleaseGraphicsResources(window);
  this->OwnRenderer.ReleaseGraphicsResources(window);
}

}
