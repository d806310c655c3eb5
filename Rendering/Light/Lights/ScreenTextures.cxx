// SPDX-License-Identifier: BSD-3-Clause
#include "Lights/ScreenTextures.h"

#include "vtkImageData.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkProjectiveLight.h"
#include "vtkTextureObject.h"

#include <algorithm>

namespace interlume
{

ScreenTextures::ScreenTextures() = default;

ScreenTextures::~ScreenTextures() = default;

vtkTextureObject* ScreenTextures::Get(
  vtkOpenGLRenderWindow* window, vtkProjectiveLight* light, vtkIdType& bytes)
{
  Screen& screen = this->Screens[light];
  if (!screen.Texture || screen.Time != light->GetMTime())
  {
    std::vector<float> texels = light->GetTexels();
    screen.Time = light->GetMTime();
    screen.Texture = vtkSmartPointer<vtkTextureObject>::New();
    screen.Texture->SetContext(window);
    const int* size = light->GetImage()->GetDimensions();
    screen.Texture->Create2DFromRaw(static_cast<unsigned int>(size[0]),
      static_cast<unsigned int>(size[1]), 3, VTK_FLOAT, texels.data());
    const int filter =
      light->GetInterpolate() ? vtkTextureObject::Linear : vtkTextureObject::Nearest;
    screen.Texture->SetMinificationFilter(filter);
    screen.Texture->SetMagnificationFilter(filter);
    screen.Texture->SetWrapS(vtkTextureObject::ClampToEdge);
    screen.Texture->SetWrapT(vtkTextureObject::ClampToEdge);
    bytes += static_cast<vtkIdType>(texels.size()) * static_cast<vtkIdType>(sizeof(float));
  }
  return screen.Texture;
}

void ScreenTextures::Keep(const std::vector<vtkProjectiveLight*>& lights, vtkWindow* window)
{
  for (auto screen = this->Screens.begin(); screen != this->Screens.end();)
  {
    if (std::find(lights.begin(), lights.end(), screen->first) == lights.end())
    {
      screen->second.Texture->ReleaseGraphicsResources(window);
      screen = this->Screens.erase(screen);
    }
    else
    {
      ++screen;
    }
  }
}

}
