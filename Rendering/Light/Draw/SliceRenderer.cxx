// SPDX-License-Identifier: BSD-3-Clause
#include "Draw/SliceRenderer.h"

#include "Common/Vectors.h"
#include "Draw/LightBufferImage.h"
#include "Draw/PicturePlan.h"
#include "Draw/SliceRasterizer.h"
#include "Draw/SliceShader.h"
#include "Draw/SliceTextures.h"
#include "Lights/LightSources.h"
#include "Loader/OpenGLFunctions.h"
#include "Plan/UnitSpaceCamera.h"
#include "Receivers/SliceScene.h"
#include "Space/UnitVector.h"
#include "Volume/MatterShare.h"

#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkOpaqueProps.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPiecewiseFunction.h"
#include "vtkProjectiveLight.h"
#include "vtkRenderer.h"
#include "vtkSliceMatter.h"
#include "vtkSoftwareOpenGL.h"
#include "vtkTimerLog.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace interlume
{

struct SliceRenderer::WindowResources
{
  SliceRasterizer Rasterizer;
  SliceTextures Textures;
  int SamplesVersion = 0;
  int MaterialVersion = 0;
  int ScatteringVersion = 0;
};

namespace
{
// Returns the plane that w + sign z >= 0 is behind, in clip coordinates.
SliceFrame::ViewPlane MakeViewPlane(const glm::dmat4& clipFromUnit, double sign)
{
  const glm::dvec4 plane = glm::row(clipFromUnit, 3) + sign * glm::row(clipFromUnit, 2);
  const glm::dvec4 scaled = plane / glm::length(glm::dvec3(plane));
  // The volume lies in the sphere of radius 1 around 0.
  return { scaled.w < 1.0, { { scaled.x, scaled.y, scaled.z, scaled.w } } };
}

// Returns all of a property that a material is made of. The time of the property itself changes
// with each volume that it is given to, and with what is set for shading.
std::vector<double> MakeKey(vtkVolumeProperty* property, int components)
{
  std::vector<double> key{ static_cast<double>(property->GetIndependentComponents()),
    static_cast<double>(property->GetTransferFunctionMode()) };
  const int rows = property->GetIndependentComponents() ? components : 1;
  for (int row = 0; row < rows; ++row)
  {
    const int channels = property->GetColorChannels(row);
    vtkObject* color = nullptr;
    if (channels == 3)
    {
      color = property->GetRGBTransferFunction(row);
    }
    else if (channels == 1)
    {
      color = property->GetGrayTransferFunction(row);
    }
    // Asking for a function that is not there, or disabled, would make one.
    const bool hasGradient =
      property->HasGradientOpacity(row) && property->GetDisableGradientOpacity(row) == 0;
    vtkObject* gradient = hasGradient ? property->GetGradientOpacity(row) : nullptr;
    const auto getTime = [](vtkObject* function)
    { return function ? static_cast<double>(function->GetMTime()) : 0.0; };
    key.insert(key.end(),
      { static_cast<double>(channels), hasGradient ? 1.0 : 0.0,
        property->GetScalarOpacityUnitDistance(row), property->GetComponentWeight(row),
        getTime(color), getTime(property->GetScalarOpacity(row)), getTime(gradient) });
  }
  return key;
}
}

SliceRenderer::SliceRenderer() = default;

SliceRenderer::~SliceRenderer() = default;

std::string SliceRenderer::UpdateSamples(const Request& request, bool isSoftware)
{
  const vtkMTimeType time = std::max(request.Image->GetMTime(), request.Scalars->GetMTime());
  std::array<int, 3> size{};
  const int* dimensions = request.Image->GetDimensions();
  for (int axis = 0; axis < 3; ++axis)
  {
    size[axis] = request.IsOfCells ? std::max(dimensions[axis] - 1, 1) : dimensions[axis];
  }
  // Images may share an array that has changed after both of them.
  if (this->Scalars == request.Scalars && this->SamplesTime == time &&
    this->Frame.Samples.Size == size && this->IsWidened == isSoftware)
  {
    return {};
  }
  this->Scalars = nullptr;
  this->MaterialOwner = nullptr;
  std::string error = this->Frame.Samples.Build(request.Scalars, size, isSoftware);
  if (error.empty())
  {
    this->Frame.SmallBlocks = VolumeBlocks();
    if (isSoftware)
    {
      this->Frame.SmallBlocks.Build(this->Frame.Samples, VolumeBlocks::SmallSize);
      this->Frame.Blocks.Join(this->Frame.SmallBlocks);
    }
    else
    {
      this->Frame.Blocks.Build(this->Frame.Samples);
    }
    this->Scalars = request.Scalars;
    this->SamplesTime = time;
    this->IsWidened = isSoftware;
    ++this->SamplesVersion;
  }
  return error;
}

std::string SliceRenderer::UpdateMaterial(vtkVolume* volume, const Request& request)
{
  vtkVolumeProperty* property = volume->GetProperty();
  std::vector<double> key = MakeKey(property, this->Frame.Samples.Components);
  vtkColorTransferFunction* transmission = request.Settings.TransmissionColor;
  const vtkMTimeType transmissionTime = transmission ? transmission->GetMTime() : 0;
  MaterialTable::Scattering scattering;
  scattering.IsOn = request.Settings.MultipleScattering != vtkShadowedSliceSettings::NO_SCATTERING;
  scattering.Albedo = scattering.IsOn ? request.Settings.ScatteringAlbedo.Get() : nullptr;
  const vtkMTimeType albedoTime = scattering.Albedo ? scattering.Albedo->GetMTime() : 0;
  if (this->MaterialOwner == property && this->MaterialKey == key &&
    this->TransmissionTime == transmissionTime && this->AlbedoTime == albedoTime &&
    this->IsScattering == scattering.IsOn)
  {
    return {};
  }
  this->MaterialOwner = nullptr;
  std::string error =
    this->Frame.Material.Build(property, this->Frame.Samples, transmission, scattering);
  if (error.empty())
  {
    this->Frame.Blocks.Classify(this->Frame.Material);
    this->Frame.SmallBlocks.Classify(this->Frame.Material);
    this->Frame.ShareOfMatter =
      MatterShare::Find(this->Frame.Samples, this->Frame.Blocks, this->Frame.Material);
    this->MaterialOwner = property;
    this->MaterialKey = std::move(key);
    this->TransmissionTime = transmissionTime;
    this->AlbedoTime = albedoTime;
    this->IsScattering = scattering.IsOn;
    ++this->MaterialVersion;
  }
  return error;
}

void SliceRenderer::UpdateShading(vtkVolume* volume)
{
  vtkVolumeProperty* property = volume->GetProperty();
  SliceFrame& frame = this->Frame;
  frame.IsShaded = property->GetShade() != 0 && !frame.Scattering.IsOn() &&
    (!frame.Matter || frame.Matter->HasReflection());
  for (int row = 0; row < frame.Material.Rows; ++row)
  {
    frame.Materials[row] = { { static_cast<float>(property->GetAmbient(row)),
      static_cast<float>(property->GetDiffuse(row)), static_cast<float>(property->GetSpecular(row)),
      static_cast<float>(property->GetSpecularPower(row)) } };
    frame.UnitDistances[row] = property->GetScalarOpacityUnitDistance(row);
  }
  glm::dvec3 ambient{ 0.0, 0.0, 0.0 };
  for (const LightSource& light : frame.Lights)
  {
    for (int i = 0; i < 3; ++i)
    {
      ambient[i] += light.Ambient[i];
    }
  }
  const bool isBlack = ambient[0] + ambient[1] + ambient[2] == 0.0;
  frame.Ambient = isBlack ? glm::dvec3(1.0, 1.0, 1.0) : ambient;
}

SliceTextures& SliceRenderer::GetTextures(vtkWindow* window)
{
  return this->Windows[window]->Textures;
}

vtkIdType SliceRenderer::GetTextureBytes() const
{
  if (this->Frame.Matter)
  {
    return SliceTextures::GetBytes(this->Frame.Scattering);
  }
  return SliceTextures::GetBytes(this->Frame.Samples) +
    SliceTextures::GetBytes(this->Frame.Material) + SliceTextures::GetBytes(this->Frame.Scattering);
}

std::string SliceRenderer::Upload(vtkOpenGLRenderWindow* window, vtkShadowedSliceReport& report)
{
  WindowResources& resources = *this->Windows[window];
  const SliceFrame& frame = this->Frame;
  SliceTextures& textures = resources.Textures;
  std::string error;
  textures.SetMatter(frame.Matter);
  if (!frame.Matter && resources.SamplesVersion != this->SamplesVersion)
  {
    error = textures.Upload(window, frame.Samples);
    resources.SamplesVersion = error.empty() ? this->SamplesVersion : 0;
    report.UploadedBytes += SliceTextures::GetBytes(frame.Samples);
  }
  if (error.empty() && !frame.Matter && resources.MaterialVersion != this->MaterialVersion)
  {
    error = textures.Upload(window, frame.Material);
    resources.MaterialVersion = error.empty() ? this->MaterialVersion : 0;
    report.UploadedBytes += SliceTextures::GetBytes(frame.Material);
  }
  if (error.empty() && resources.ScatteringVersion != this->Scatterer.GetVersion())
  {
    error = textures.Upload(window, frame.Scattering);
    resources.ScatteringVersion = error.empty() ? this->Scatterer.GetVersion() : 0;
    report.UploadedBytes += SliceTextures::GetBytes(frame.Scattering);
  }
  std::vector<vtkProjectiveLight*> screens;
  for (const LightSource& light : frame.Lights)
  {
    if (light.Projective && light.Projective->GetImage())
    {
      screens.push_back(light.Projective);
    }
  }
  textures.GetScreens().Keep(screens, window);
  return error;
}

void SliceRenderer::AddField(vtkOpenGLRenderWindow* window, SliceScene& scene)
{
  const SliceScattering& scattering = this->Frame.Scattering;
  if (!scattering.HasField())
  {
    return;
  }
  ScatteredField field;
  field.Texture = this->GetTextures(window).GetScattered();
  field.Nodes = scattering.Nodes;
  field.NodeFromWorld = scattering.NodeFromUnit * this->Frame.Space.GetUnitFromWorld();
  field.HasFluence = scattering.HasFluence;
  field.BlockedCells = this->Scatterer.GetBlockedCells();
  for (const vtkLight* known : scattering.ForwardLights)
  {
    const auto light = std::find_if(this->Frame.Lights.begin(), this->Frame.Lights.end(),
      [known](const LightSource& source) { return source.Light == known; });
    field.Lights.push_back(light->Light);
  }
  scene.Fields.push_back(field);
}

std::string SliceRenderer::UpdateVolume(
  vtkOpenGLRenderWindow* window, vtkVolume* volume, const Request& request)
{
  std::unique_ptr<WindowResources>& resources = this->Windows[window];
  if (!resources)
  {
    resources = std::make_unique<WindowResources>();
  }
  if (!window)
  {
    return "the render window is not an OpenGL one";
  }
  std::string error = SliceRasterizer::FindFault(window);
  if (error.empty())
  {
    this->Frame.IsSoftware = vtkSoftwareOpenGL::IsUsed(window);
    error = this->UpdateSamples(request, this->Frame.IsSoftware);
  }
  if (error.empty())
  {
    error = this->UpdateMaterial(volume, request);
  }
  if (error.empty())
  {
    error = this->Scatterer.SetPhase(request.Settings, this->Frame.Scattering);
  }
  SliceFrame& frame = this->Frame;
  frame.Matter = request.Matter;
  frame.Number = 0;
  frame.HasColoredLight = false;
  if (error.empty())
  {
    error = frame.Space.Set(request.Image, request.IsOfCells, volume->GetMatrix());
  }
  if (error.empty())
  {
    error = frame.Region.Set(request.Cuts, frame.Space);
  }
  if (error.empty())
  {
    // Magnitudes do not depend on which way an axis goes.
    const glm::dvec3 spacing = glm::abs(glm::make_vec3(request.Image->GetSpacing()));
    frame.GradientSteps = (spacing.x + spacing.y + spacing.z) / 3.0 / spacing;
  }
  return error;
}

void SliceRenderer::MoveTo(const Request& request, const glm::dvec3& center, double radius)
{
  this->Frame.Space.MoveTo(center, radius);
  this->Frame.Region.Set(request.Cuts, this->Frame.Space);
}

void SliceRenderer::UpdateView(vtkRenderer* renderer, vtkVolume* volume, const Request& request,
  double coarseness, std::vector<std::string>& warnings, vtkShadowedSliceReport& report)
{
  SliceFrame& frame = this->Frame;
  report.ImageSampleDistance = request.Settings.ImageSampleDistance * coarseness;
  int width = 0;
  int height = 0;
  int left = 0;
  int bottom = 0;
  renderer->GetTiledSizeAndOrigin(&width, &height, &left, &bottom);
  const auto toPixels = [&report](int size)
  { return std::max(static_cast<int>(std::lround(size / report.ImageSampleDistance)), 1); };
  frame.Size = { { toPixels(width), toPixels(height) } };
  frame.Eye = UnitSpaceCamera::Get(renderer, frame.Space);
  frame.NearPlane = MakeViewPlane(frame.Eye.ClipFromUnit, 1.0);
  frame.FarPlane = MakeViewPlane(frame.Eye.ClipFromUnit, -1.0);
  frame.Lights = LightSources::Gather(renderer, frame.Space,
    { request.Settings.Shadows && !renderer->GetSelector(),
      request.Settings.MaximumNumberOfShadows },
    warnings);
  this->UpdateShading(volume);
  frame.SurfaceGradient = request.Settings.SurfaceGradient;
  frame.TwoSidedLighting = request.Settings.TwoSidedLighting;
  frame.IsSmoothLookup = request.Settings.LightLookup == vtkShadowedSliceSettings::BILINEAR_LIGHT;
  frame.Scene = request.Scene;
  frame.MayBeOccluded = vtkOpaqueProps::MayOcclude(renderer, volume);
  report.Blocks = frame.Blocks.GetNumberOfBlocks();
  report.BlocksDrawn = frame.Blocks.GetNumberVisible();
  report.NonFiniteVoxels = frame.Samples.NonFinite;
}

SliceScatterer::Matter SliceRenderer::GetScatteringMatter(const Request& request) const
{
  return { &this->Frame, { { this->SamplesVersion, this->MaterialVersion } },
    request.Settings.ScatteringGridSize };
}

std::string SliceRenderer::UpdateScattering(vtkRenderer* renderer, const Request& request,
  const std::vector<SliceScatterer::Matter>& matter, const SliceRenderer* other,
  vtkShadowedSliceReport& report)
{
  // A selection is drawn without lights, and what they have scattered is kept.
  const std::string error = renderer->GetSelector()
    ? std::string()
    : this->Scatterer.Solve(vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()),
        this->Frame, matter, request.Settings, other ? &other->Scatterer : nullptr,
        other ? &other->Frame.Scattering : nullptr, report);
  report.TextureBytes = this->GetTextureBytes();
  return error;
}

SlicePlan::Matter SliceRenderer::GetMatter(const Request& request) const
{
  return { &this->Frame.Space, this->Frame.Region.Box,
    request.Settings.SliceSpacing / this->Frame.Space.Radius,
    this->Frame.Material.HasSharpOpacity() ? 0.0 : SliceShader::GetRampExtinction(this->Frame) };
}

std::string SliceRenderer::Update(vtkRenderer* renderer, vtkVolume* volume, const Request& request,
  std::vector<std::string>& warnings, vtkShadowedSliceReport& report)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  const std::string error = this->UpdateVolume(window, volume, request);
  if (!error.empty())
  {
    return error;
  }
  const double coarseness = request.Settings.AutoAdjustSampleDistances
    ? PicturePlan::ChooseCoarseness(
        this->LastSeconds, this->LastCoarseness, volume->GetAllocatedRenderTime())
    : 1.0;
  this->UpdateView(renderer, volume, request, coarseness, warnings, report);
  const std::string fault = this->UpdateScattering(
    renderer, request, { this->GetScatteringMatter(request) }, nullptr, report);
  if (!fault.empty())
  {
    return fault;
  }
  PicturePlan::Make(
    this->Frame, { this->GetMatter(request) }, request.Settings, coarseness, report);
  this->LastCoarseness = coarseness;
  const vtkIdType bytes = report.TextureBytes + PicturePlan::GetBufferBytes({ &this->Frame });
  if (request.Settings.MaximumTextureMemory > 0 && bytes > request.Settings.MaximumTextureMemory)
  {
    return "textures and buffers of the picture take " + std::to_string(bytes) +
      " bytes, and MaximumTextureMemory is " +
      std::to_string(request.Settings.MaximumTextureMemory);
  }
  return this->Upload(window, report);
}

std::string SliceRenderer::Render(vtkRenderer* renderer, vtkVolume* volume, const Request& request,
  std::vector<std::string>& warnings, vtkShadowedSliceReport& report)
{
  const double start = vtkTimerLog::GetUniversalTime();
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  std::string error = this->Update(renderer, volume, request, warnings, report);
  const std::unique_ptr<WindowResources>& resources = this->Windows[window];
  if (error.empty())
  {
    const auto isAborted = [window]() { return window->CheckAbortStatus() != 0; };
    error = resources->Rasterizer.Draw(
      renderer, { { &this->Frame, &resources->Textures } }, isAborted, report);
  }
  if (error.empty() && request.Scene)
  {
    this->AddField(window, *request.Scene);
  }
  // The scene is gone when the picture has been drawn.
  this->Frame.Scene = nullptr;
  if (request.Scene)
  {
    report.Seconds = vtkTimerLog::GetUniversalTime() - start;
  }
  else if (window && renderer->GetSelector())
  {
    resources->Rasterizer.ShowSelection(renderer->GetSelector(), window);
  }
  else if (window)
  {
    resources->Rasterizer.Show(window);
  }
  if (error.empty() && request.Settings.AutoAdjustSampleDistances)
  {
    glFinish();
    this->LastSeconds = vtkTimerLog::GetUniversalTime() - start;
  }
  report.Seconds = vtkTimerLog::GetUniversalTime() - start;
  return error;
}

void SliceRenderer::ShowLast(vtkRenderer* renderer)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  const auto resources = this->Windows.find(window);
  if (window && resources != this->Windows.end())
  {
    resources->second->Rasterizer.Show(window);
  }
}

bool SliceRenderer::ReadLightBuffer(vtkRenderer* renderer, vtkLight* light, vtkImageData* image)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  const auto resources = this->Windows.find(window);
  return resources != this->Windows.end() &&
    LightBufferImage::Read(resources->second->Rasterizer,
      { this->Frame.Plan, this->Frame.Lights, this->Frame.Space }, window, light, image);
}

void SliceRenderer::ReleasePicture(vtkWindow* window)
{
  const auto resources = this->Windows.find(window);
  if (resources != this->Windows.end())
  {
    resources->second->Rasterizer.ReleaseGraphicsResources(window);
  }
}

void SliceRenderer::ReleaseGraphicsResources(vtkWindow* window)
{
  for (auto& resources : this->Windows)
  {
    if (!window || resources.first == window)
    {
      resources.second->Rasterizer.ReleaseGraphicsResources(resources.first);
      resources.second->Textures.ReleaseGraphicsResources(resources.first);
    }
  }
  if (window)
  {
    this->Windows.erase(window);
  }
  else
  {
    this->Windows.clear();
  }
}

}
