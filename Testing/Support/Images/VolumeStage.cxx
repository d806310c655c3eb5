// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Images/VolumeStage.h"

#include "Support/Arrays/ReferenceIndices.h"
#include "Support/Images/TestWindow.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCameraPass.h"
#include "vtkFramebufferPass.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkLightsPass.h"
#include "vtkOpaquePass.h"
#include "vtkPixelBufferObject.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSequencePass.h"
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"
#include "vtkVolumetricPass.h"

#include <sstream>
#include <stdexcept>

namespace reference
{

namespace
{
/// Windows of former stages, with their compiled shaders. The list is never freed, since VTK cannot
/// close windows after the end of main().
std::vector<vtkSmartPointer<vtkRenderWindow>>& GetFreeWindows()
{
  static auto* const windows = new std::vector<vtkSmartPointer<vtkRenderWindow>>;
  return *windows;
}

vtkSmartPointer<vtkRenderWindow> TakeWindow()
{
  auto& windows = GetFreeWindows();
  if (windows.empty())
  {
    return vtkSmartPointer<vtkRenderWindow>::New();
  }
  const vtkSmartPointer<vtkRenderWindow> window = windows.back();
  windows.pop_back();
  return window;
}
}

VolumeStage::VolumeStage(const std::array<int, 2>& size)
  : Window(TakeWindow())
{
  this->Window->SetOffScreenRendering(1);
  this->Window->SetMultiSamples(0);
  this->Window->SetSize(size[0], size[1]);
  this->Window->AddRenderer(this->Renderer);
  this->Renderer->SetBackground(0.0, 0.0, 0.0);
  this->Renderer->SetBackgroundAlpha(0.0);
  this->Renderer->AddVolume(this->Volume);

  vtkNew<vtkRenderPassCollection> passes;
  passes->AddItem(vtkNew<vtkLightsPass>());
  passes->AddItem(vtkNew<vtkOpaquePass>());
  passes->AddItem(vtkNew<vtkVolumetricPass>());
  vtkNew<vtkSequencePass> sequence;
  sequence->SetPasses(passes);
  vtkNew<vtkCameraPass> camera;
  camera->SetDelegatePass(sequence);
  this->Pass->SetDelegatePass(camera);
  this->Pass->SetColorFormat(vtkTextureObject::Float32);
  // vtkGPUVolumeRayCastMapper copies the depth buffer to a texture of this format.
  this->Pass->SetDepthFormat(vtkTextureObject::Fixed32);
  MuteShaderCompiler(this->Window);
}

VolumeStage::~VolumeStage()
{
  this->Release(this->Pass);
  this->Window->RemoveRenderer(this->Renderer);
  if (this->CanReuseWindow)
  {
    GetFreeWindows().push_back(this->Window);
  }
}

void VolumeStage::SetVolume(vtkAbstractVolumeMapper* mapper, vtkVolumeProperty* property)
{
  this->Volume->SetMapper(mapper);
  this->Volume->SetProperty(property);
}

vtkVolume* VolumeStage::GetVolume()
{
  return this->Volume;
}

void VolumeStage::AddActor(vtkActor* actor)
{
  this->Renderer->AddActor(actor);
}

void VolumeStage::SetLights(const std::vector<vtkSmartPointer<vtkLight>>& lights)
{
  this->Renderer->AutomaticLightCreationOff();
  vtkLightCollection* present = this->Renderer->GetLights();
  bool isSame = present->GetNumberOfItems() == static_cast<int>(lights.size());
  for (std::size_t i = 0; isSame && i < lights.size(); ++i)
  {
    isSame = present->GetItemAsObject(static_cast<int>(i)) == lights[i].Get();
  }
  if (isSame)
  {
    // The renderer already has these lights. Replacing them would modify the collection, and VTK
    // would rebuild its shaders.
    return;
  }
  this->Renderer->RemoveAllLights();
  for (vtkLight* light : lights)
  {
    this->Renderer->AddLight(light);
  }
}

void VolumeStage::SetCamera(vtkCamera* camera)
{
  this->Renderer->SetActiveCamera(camera);
}

void VolumeStage::SetPass(vtkRenderPass* pass)
{
  this->Pass->SetDelegatePass(pass);
}

void VolumeStage::Release(vtkRenderPass* pass)
{
  this->Window->MakeCurrent();
  pass->ReleaseGraphicsResources(this->Window);
}

vtkRenderer* VolumeStage::GetRenderer()
{
  return this->Renderer;
}

vtkRenderWindow* VolumeStage::GetWindow()
{
  this->CanReuseWindow = false;
  return this->Window;
}

void VolumeStage::Render()
{
  this->Renderer->SetPass(nullptr);
  this->Window->Render();
  this->Window->WaitForCompletion();
}

RgbaImage VolumeStage::Capture(int frames)
{
  this->Renderer->SetPass(this->Pass);
  // With a render pass, the renderer does not update lights that follow the camera.
  this->Renderer->UpdateLightsGeometryToFollowCamera();
  for (int i = 0; i < frames; ++i)
  {
    this->Window->Render();
  }
  vtkTextureObject* texture = this->Pass->GetColorTexture();
  if (!texture)
  {
    throw std::runtime_error("the pass has no floating-point framebuffer");
  }
  const unsigned int size[2] = { texture->GetWidth(), texture->GetHeight() };
  const auto buffer = vtkSmartPointer<vtkPixelBufferObject>::Take(texture->Download());
  RgbaImage image(static_cast<int>(size[0]), static_cast<int>(size[1]));
  std::vector<float> values(image.Values.size());
  unsigned int dimensions[2] = { size[0], size[1] };
  vtkIdType increments[2] = { 0, 0 };
  if (!buffer->Download2D(VTK_FLOAT, values.data(), dimensions, 4, increments))
  {
    throw std::runtime_error("the floating-point framebuffer cannot be read");
  }
  image.Values.assign(values.begin(), values.end());
  return image;
}

RgbaImage VolumeStage::CaptureBytes()
{
  return ReadWindow(this->Window);
}

std::string VolumeStage::GetDevice()
{
  this->Render();
  std::istringstream capabilities(this->Window->ReportCapabilities());
  const std::string name = "OpenGL renderer string:";
  for (std::string line; std::getline(capabilities, line);)
  {
    const std::size_t at = line.find(name);
    if (at != std::string::npos)
    {
      const std::size_t begin = line.find_first_not_of(' ', at + name.size());
      return begin == std::string::npos ? std::string() : line.substr(begin);
    }
  }
  return {};
}

RgbaImage ReadWindow(vtkRenderWindow* window)
{
  window->Render();
  const int* size = window->GetSize();
  RgbaImage image(size[0], size[1]);
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels);
  for (const auto& [j, i, k] : AllIndices(size[1], size[0], 4))
  {
    image.At(i, j)[k] = k == 3 ? 1.0 : pixels->GetComponent(j * size[0] + i, k) / 255.0;
  }
  return image;
}

}
