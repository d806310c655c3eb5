// SPDX-License-Identifier: BSD-3-Clause
#include "Refinement/ImageKey.h"

#include "Offscreen/SceneDepth.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkCamera.h"
#include "vtkDataObject.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTimeStamp.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <array>
#include <cstring>

namespace interlume
{

ImageKey::ImageKey(vtkRenderer* renderer, vtkVolume* volume, vtkAbstractVolumeMapper* mapper)
{
  this->AddView(renderer);
  this->AddLights(renderer);
  this->Add(volume->GetMatrix());
  this->Add(volume->GetProperty());
  this->Add(mapper);
  for (int port = 0; port < mapper->GetNumberOfInputPorts(); ++port)
  {
    this->Add(mapper->GetNumberOfInputConnections(port) > 0 ? mapper->GetInputDataObject(port, 0)
                                                            : nullptr);
  }
  this->AddDepths(renderer, volume);
}

void ImageKey::Add(vtkObject* object)
{
  this->Values.push_back(reinterpret_cast<std::uintptr_t>(object));
  this->Values.push_back(object ? object->GetMTime() : 0);
}

void ImageKey::Add(const double* numbers, int count)
{
  for (int i = 0; i < count; ++i)
  {
    this->Values.emplace_back();
    std::memcpy(&this->Values.back(), numbers + i, sizeof(double));
  }
}

void ImageKey::Add(vtkMatrix4x4* matrix)
{
  // An absent matrix and the identity matrix transform equally.
  const vtkNew<vtkMatrix4x4> identity;
  this->Add((matrix ? matrix : identity.Get())->GetData(), 16);
}

void ImageKey::AddView(vtkRenderer* renderer)
{
  std::array<int, 4> viewport{};
  renderer->GetTiledSizeAndOrigin(&viewport[0], &viewport[1], &viewport[2], &viewport[3]);
  this->Values.insert(this->Values.end(), viewport.begin(), viewport.end());
  this->Values.push_back(reinterpret_cast<std::uintptr_t>(renderer->GetRenderWindow()));
  vtkCamera* camera = renderer->GetActiveCamera();
  this->Values.push_back(static_cast<std::uint64_t>(camera->GetParallelProjection()));
  this->Add(camera->GetModelViewTransformMatrix());
  this->Add(camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1.0, 1.0));
}

void ImageKey::AddLights(vtkRenderer* renderer)
{
  // The camera's transform of camera lights is in the key even if they do not follow the camera.
  vtkCamera* camera = renderer->GetActiveCamera();
  this->Add(camera->GetCameraLightTransformMatrix());
  this->Add(camera->GetPosition(), 3);
  this->Add(camera->GetFocalPoint(), 3);
  this->Values.push_back(static_cast<std::uint64_t>(renderer->GetLightFollowCamera()));
  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator iterator;
  lights->InitTraversal(iterator);
  while (vtkLight* light = lights->GetNextLight(iterator))
  {
    this->Add(light);
    this->Add(light->GetTransformMatrix());
  }
}

void ImageKey::AddDepths(vtkRenderer* renderer, vtkVolume* volume)
{
  const bool mayOcclude = SceneDepth::MayOcclude(renderer, volume);
  this->Values.push_back(mayOcclude ? 1 : 0);
  std::array<int, 2> size{};
  if (mayOcclude && !SceneDepth::Read(renderer, this->Depths, size))
  {
    // The depths are unknown, so the key must differ from all others.
    vtkTimeStamp unknown;
    unknown.Modified();
    this->Values.push_back(unknown);
  }
}

}
