// SPDX-License-Identifier: BSD-3-Clause
#include "Translucent/DepthLayers.h"

#include "Translucent/LayerShader.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkTextureObject.h"

namespace interlume
{

DepthLayers::DepthLayers() = default;

DepthLayers::~DepthLayers() = default;

Error DepthLayers::Peel(vtkOpenGLRenderWindow* window, int width, const std::vector<float>& behind,
  std::size_t maximum, LayerShader& shader, const std::function<void()>& draw)
{
  const int height = static_cast<int>(behind.size()) / width;
  std::size_t found = 0;
  Error error;
  for (bool isLast = false; !isLast && !error; found += isLast ? 0 : 1)
  {
    if (found == this->Layers.size())
    {
      this->Layers.emplace_back();
      this->Layers.back().Texture = vtkSmartPointer<vtkTextureObject>::New();
    }
    Layer& layer = this->Layers[found];
    layer.HasRest = false;
    if (!LayerTarget::Upload(window, layer.Texture, width, height, 1, behind))
    {
      error = Error("The graphics card does not have enough memory for the layers of translucent "
                    "surfaces. Reduce MaximumNumberOfLayers.",
        ErrorCode::OutOfMemory);
      break;
    }
    vtkTextureObject* before = found > 0 ? this->Layers[found - 1].Texture.Get() : nullptr;
    if (before)
    {
      before->Activate();
    }
    shader.Begin(before ? LayerShader::NEXT : LayerShader::FIRST, before);
    this->Target.Draw(window, layer.Texture, LayerTarget::MINIMUM, draw);
    shader.Begin(LayerShader::SHOW);
    if (before)
    {
      before->Deactivate();
    }
    layer.Depths = LayerTarget::Read(layer.Texture);
    isLast = layer.Depths == behind;
    if (!isLast && found == maximum)
    {
      // There are more than the maximum number of layers, so the last layer includes all surfaces
      // behind it.
      this->Layers[found - 1].HasRest = true;
      isLast = true;
    }
  }
  for (std::size_t i = found; i < this->Layers.size(); ++i)
  {
    this->Layers[i].Texture->ReleaseGraphicsResources(window);
  }
  this->Layers.resize(found);
  return error;
}

vtkIdType DepthLayers::GetBytes() const
{
  vtkIdType bytes = 0;
  for (const Layer& layer : this->Layers)
  {
    bytes += static_cast<vtkIdType>(layer.Depths.size() * sizeof(float));
  }
  return bytes;
}

void DepthLayers::ReleaseGraphicsResources(vtkWindow* window)
{
  for (const Layer& layer : this->Layers)
  {
    layer.Texture->ReleaseGraphicsResources(window);
  }
  this->Layers.clear();
  this->Target.ReleaseGraphicsResources(window);
}

}
