// SPDX-License-Identifier: BSD-3-Clause
#include "Draw/SliceRenderer.h"

#include "Common/Vectors.h"
#include "Draw/SliceRasterizer.h"
#include "Draw/SliceShader.h"
#include "Lights/EmitterSamples.h"
#include "Lights/LightSources.h"
#include "Loader/OpenGLFunctions.h"
#include "Plan/UnitSpaceCamera.h"

#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkHardwareSelector.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOpaqueProps.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointData.h"
#include "vtkProjectiveLight.h"
#include "vtkRenderer.h"
#include "vtkSoftwareOpenGL.h"
#include "vtkTimerLog.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>

namespace interlume
{

struct SliceRenderer::WindowResources
{
  SliceRasterizer Rasterizer;
  int SamplesVersion = 0;
  int MaterialVersion = 0;
};

namespace
{
// Finds the near plane: clip coordinates have z + w >= 0 behind it.
void FindNearPlane(SliceFrame& frame)
{
  const glm::dmat4& clip = frame.Eye.ClipFromUnit;
  double length = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    frame.NearPlane[i] = clip[i][2] + clip[i][3];
    length += i < 3 ? frame.NearPlane[i] * frame.NearPlane[i] : 0.0;
  }
  length = std::sqrt(length);
  for (double& value : frame.NearPlane)
  {
    value /= length;
  }
  // The volume lies in the sphere of radius 1 around 0.
  frame.IsCutByNearPlane = frame.NearPlane[3] < 1.0;
}

// Shows the prop as a whole: in passes that ask for it, for its process and for its only block.
void ShowSelection(
  vtkHardwareSelector* selector, vtkOpenGLRenderWindow* window, SliceRasterizer& painter)
{
  std::array<float, 3> color{ { 0.0f, 0.0f, 0.0f } };
  selector->BeginRenderProp();
  switch (selector->GetCurrentPass())
  {
    case vtkHardwareSelector::ACTOR_PASS:
      std::copy_n(selector->GetPropColorValue(), 3, color.begin());
      painter.ShowSelection(window, color);
      break;
    case vtkHardwareSelector::PROCESS_PASS:
      vtkHardwareSelector::Convert(selector->GetProcessID() + 1, color.data());
      painter.ShowSelection(window, color);
      break;
    case vtkHardwareSelector::COMPOSITE_INDEX_PASS:
      vtkHardwareSelector::Convert(1, color.data());
      painter.ShowSelection(window, color);
      break;
    default:
      break;
  }
  selector->EndRenderProp();
}

// The spacing of slices along their normal, in voxels.
constexpr double AUTOMATIC_SPACING = 0.5;

// The factors by which pictures may be coarser than asked for.
constexpr std::array<double, 5> COARSENESSES{ { 1.0, 1.5, 2.0, 3.0, 4.0 } };
}

SliceRenderer::SliceRenderer() = default;

SliceRenderer::~SliceRenderer() = default;

std::string SliceRenderer::UpdateSamples(const Request& request, bool isSoftware)
{
  const vtkMTimeType time = std::max(request.Image->GetMTime(), request.Scalars->GetMTime());
  if (this->Scalars == request.Scalars && this->SamplesTime == time &&
    this->IsWidened == isSoftware)
  {
    return {};
  }
  this->Scalars = nullptr;
  this->MaterialOwner = nullptr;
  std::array<int, 3> size{};
  const int* dimensions = request.Image->GetDimensions();
  for (int axis = 0; axis < 3; ++axis)
  {
    size[axis] = request.IsOfCells ? std::max(dimensions[axis] - 1, 1) : dimensions[axis];
  }
  std::string error = this->Frame.Samples.Build(request.Scalars, size, isSoftware);
  if (error.empty())
  {
    this->Frame.Blocks.Build(this->Frame.Samples);
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
  const vtkMTimeType time = property->GetMTime();
  vtkColorTransferFunction* transmission = request.Settings.TransmissionColor;
  const vtkMTimeType transmissionTime = transmission ? transmission->GetMTime() : 0;
  if (this->MaterialOwner == property && this->MaterialTime == time &&
    this->TransmissionTime == transmissionTime)
  {
    return {};
  }
  this->MaterialOwner = nullptr;
  std::string error = this->Frame.Material.Build(property, this->Frame.Samples, transmission);
  if (error.empty())
  {
    this->Frame.Blocks.Classify(this->Frame.Material);
    this->MaterialOwner = property;
    this->MaterialTime = time;
    this->TransmissionTime = transmissionTime;
    ++this->MaterialVersion;
  }
  return error;
}

void SliceRenderer::UpdateShading(vtkVolume* volume)
{
  vtkVolumeProperty* property = volume->GetProperty();
  SliceFrame& frame = this->Frame;
  frame.IsShaded = property->GetShade() != 0;
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

double SliceRenderer::ChooseCoarseness(vtkVolume* volume, const Request& request)
{
  if (!request.Settings.AutoAdjustSampleDistances)
  {
    return 1.0;
  }
  // The time of a full picture counts slices and pixels along both edges.
  const double full = this->LastSeconds * std::pow(this->LastCoarseness, 3.0);
  const double allocated = volume->GetAllocatedRenderTime();
  for (double coarseness : COARSENESSES)
  {
    if (full <= allocated * std::pow(coarseness, 3.0))
    {
      return coarseness;
    }
  }
  return COARSENESSES.back();
}

std::string SliceRenderer::Upload(
  vtkRenderer* renderer, const Request& request, vtkShadowedSliceReport& report)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  WindowResources& resources = *this->Windows[window];
  const SliceFrame& frame = this->Frame;
  const vtkIdType samples = SliceTextures::GetBytes(frame.Samples);
  const vtkIdType tables = SliceTextures::GetBytes(frame.Material);
  report.TextureBytes = samples + tables;
  vtkIdType bytes = report.TextureBytes;
  const vtkIdType pixels = static_cast<vtkIdType>(frame.Size[0]) * frame.Size[1];
  bytes +=
    pixels * static_cast<vtkIdType>(sizeof(float)) * (frame.Plan.HasFurtherPictures() ? 9 : 5);
  for (std::size_t sweep = 0; sweep < frame.Plan.Sweeps.size(); ++sweep)
  {
    // Thick matter needs two layers of each buffer.
    const int buffers = SliceShader::HasThickPart(frame, sweep) ? 3 : 1;
    for (const SlicePlan::ShadowedLight& light : frame.Plan.Sweeps[sweep].Lights)
    {
      bytes += static_cast<vtkIdType>(sizeof(float)) * light.BufferSize * light.BufferSize *
        frame.GetLightChannels() *
        ((light.IsWide ? 1 : buffers) + SliceLightBuffer::GetNumberOfSoftBuffers(light));
    }
  }
  if (request.Settings.MaximumTextureMemory > 0 && bytes > request.Settings.MaximumTextureMemory)
  {
    return "textures and buffers of the picture take " + std::to_string(bytes) +
      " bytes, and MaximumTextureMemory is " +
      std::to_string(request.Settings.MaximumTextureMemory);
  }
  SliceTextures& textures = resources.Rasterizer.GetTextures();
  std::string error;
  if (resources.SamplesVersion != this->SamplesVersion)
  {
    error = textures.Upload(window, frame.Samples);
    resources.SamplesVersion = error.empty() ? this->SamplesVersion : 0;
    report.UploadedBytes += samples;
  }
  if (error.empty() && resources.MaterialVersion != this->MaterialVersion)
  {
    error = textures.Upload(window, frame.Material);
    resources.MaterialVersion = error.empty() ? this->MaterialVersion : 0;
    report.UploadedBytes += tables;
  }
  std::vector<vtkProjectiveLight*> screens;
  for (const LightSource& light : frame.Lights)
  {
    if (light.Projective && light.Projective->GetImage())
    {
      screens.push_back(light.Projective);
    }
  }
  textures.KeepScreens(screens, window);
  return error;
}

void SliceRenderer::MakePlan(
  const Request& request, SlicePlan::Settings settings, vtkShadowedSliceReport& report)
{
  SliceFrame& frame = this->Frame;
  const auto isSoft = [](const LightSource& light)
  { return light.Area != nullptr && light.ShadowStrength > 0.0; };
  const std::size_t lights = frame.Lights.size();
  report.ShadowedLights = static_cast<int>(std::count_if(frame.Lights.begin(), frame.Lights.end(),
    [](const LightSource& light) { return light.ShadowStrength > 0.0; }));
  report.SoftLights =
    static_cast<int>(std::count_if(frame.Lights.begin(), frame.Lights.end(), isSoft));

  const int samples = request.Settings.NumberOfLightSamples;
  std::vector<int> sampled;
  if (report.SoftLights > 0)
  {
    constexpr std::array<const char*, 3> names{ { "AccumulatedConvolution", "SampleLayers",
      "SampledLights" } };
    const int method = request.Settings.SoftShadowMethod;
    report.SoftShadowMethod = names[method];
    settings.Samples = samples;
    settings.SoftMethod = method == vtkShadowedSliceSettings::SAMPLE_LAYERS ? SlicePlan::LAYERS
      : method == vtkShadowedSliceSettings::ACCUMULATED_CONVOLUTION         ? SlicePlan::CONVOLUTION
                                                                            : SlicePlan::HARD;
    for (std::size_t i = 0; i < lights && settings.SoftMethod == SlicePlan::HARD; ++i)
    {
      if (isSoft(frame.Lights[i]))
      {
        sampled.push_back(static_cast<int>(i));
      }
    }
  }
  // A surface of a scene takes what is left of a light once: shares of samples would be multiplied.
  std::vector<int> hard = frame.Scene ? sampled : std::vector<int>();
  if (hard.empty() && !sampled.empty())
  {
    frame.Lights = EmitterSamples::Split(frame.Lights, sampled, samples);
    report.SampledLights = samples * static_cast<int>(sampled.size());
  }
  if (hard.empty())
  {
    frame.Plan.Make(frame.Eye, frame.Lights, frame.Space, frame.Region.Box, settings);
    hard = frame.Plan.NotSoft;
  }
  report.HardLightsInstead = static_cast<int>(hard.size());
  if (!hard.empty())
  {
    for (const int light : hard)
    {
      frame.Lights[static_cast<std::size_t>(light)].Area = nullptr;
    }
    frame.Plan.Make(frame.Eye, frame.Lights, frame.Space, frame.Region.Box, settings);
  }
  report.Lights = frame.IsLit() ? static_cast<int>(lights) : 0;
}

std::string SliceRenderer::Update(vtkRenderer* renderer, vtkVolume* volume, const Request& request,
  std::vector<std::string>& warnings, vtkShadowedSliceReport& report)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!window)
  {
    return "the render window is not an OpenGL one";
  }
  std::string error = SliceRasterizer::FindFault(window);
  if (error.empty())
  {
    error = this->UpdateSamples(request, vtkSoftwareOpenGL::IsUsed(window));
  }
  if (error.empty())
  {
    error = this->UpdateMaterial(volume, request);
  }
  SliceFrame& frame = this->Frame;
  if (error.empty())
  {
    error = frame.Space.Set(request.Image, request.IsOfCells, volume->GetMatrix());
  }
  if (error.empty())
  {
    frame.Region.SetWhole(frame.Space);
    if (request.Cropping)
    {
      frame.Region.Crop(request.Image, request.IsOfCells, frame.Space, request.CroppingPlanes,
        request.CroppingFlags);
    }
    error = frame.Region.Clip(request.ClippingPlanes, frame.Space);
  }
  if (!error.empty())
  {
    return error;
  }
  request.Image->GetSpacing(glm::value_ptr(frame.Spacing));
  const double coarseness = this->ChooseCoarseness(volume, request);
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
  FindNearPlane(frame);
  frame.Lights = LightSources::Gather(renderer, frame.Space,
    { request.Settings.Shadows && !renderer->GetSelector(),
      request.Settings.MaximumNumberOfShadows },
    warnings);
  this->UpdateShading(volume);
  frame.SurfaceGradient = request.Settings.SurfaceGradient;
  frame.IsSmoothLookup = request.Settings.LightLookup == vtkShadowedSliceSettings::BILINEAR_LIGHT;
  frame.Scene = request.Scene;
  frame.MayBeOccluded = vtkOpaqueProps::MayOcclude(renderer, volume);

  SlicePlan::Settings settings;
  settings.Spacing = request.Settings.SliceSpacing / frame.Space.Radius;
  settings.AutomaticFactor = AUTOMATIC_SPACING * coarseness;
  settings.BufferSize = request.Settings.LightBufferSize;
  GLint limit = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
  settings.LargestBufferSize = std::min(settings.LargestBufferSize, static_cast<int>(limit));
  this->MakePlan(request, settings, report);

  report.Sweeps = static_cast<int>(frame.Plan.Sweeps.size());
  report.FrontToBackSweeps = static_cast<int>(std::count_if(frame.Plan.Sweeps.begin(),
    frame.Plan.Sweeps.end(), [](const SlicePlan::Sweep& sweep) { return sweep.IsFrontToBack; }));
  report.SliceSpacing = frame.Plan.Sweeps[0].Spacing * frame.Space.Radius;
  report.Blocks = frame.Blocks.GetNumberOfBlocks();
  report.BlocksDrawn = frame.Blocks.GetNumberVisible();
  report.NonFiniteVoxels = frame.Samples.NonFinite;
  this->LastCoarseness = coarseness;
  return this->Upload(renderer, request, report);
}

std::string SliceRenderer::Render(vtkRenderer* renderer, vtkVolume* volume, const Request& request,
  std::vector<std::string>& warnings, vtkShadowedSliceReport& report)
{
  const double start = vtkTimerLog::GetUniversalTime();
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  std::unique_ptr<WindowResources>& resources = this->Windows[window];
  if (!resources)
  {
    resources = std::make_unique<WindowResources>();
  }
  std::string error = this->Update(renderer, volume, request, warnings, report);
  if (error.empty())
  {
    const auto isAborted = [window]() { return window->CheckAbortStatus() != 0; };
    error = resources->Rasterizer.Draw(renderer, this->Frame, isAborted, report);
  }
  // The scene is gone when the picture has been drawn.
  this->Frame.Scene = nullptr;
  if (request.Scene)
  {
    report.Seconds = vtkTimerLog::GetUniversalTime() - start;
  }
  else if (window && renderer->GetSelector())
  {
    ShowSelection(renderer->GetSelector(), window, resources->Rasterizer);
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
  if (resources == this->Windows.end())
  {
    return false;
  }
  const UnitSpace& space = this->Frame.Space;
  for (const SlicePlan::Sweep& sweep : this->Frame.Plan.Sweeps)
  {
    for (const SlicePlan::ShadowedLight& shadowed : sweep.Lights)
    {
      if (this->Frame.Lights[shadowed.Light].Light != light)
      {
        continue;
      }
      int size = 0;
      int channels = 0;
      const std::vector<float> texels =
        resources->second->Rasterizer.ReadLightBuffer(window, shadowed.Light, size, channels);
      if (texels.empty())
      {
        return false;
      }
      image->Initialize();
      image->SetDimensions(size, size, 1);
      vtkNew<vtkFloatArray> values;
      values->SetName("Transmittance");
      values->SetNumberOfComponents(channels);
      values->SetNumberOfTuples(static_cast<vtkIdType>(size) * size);
      std::copy(texels.begin(), texels.end(), values->GetPointer(0));
      image->GetPointData()->SetScalars(values);

      // The matrix leads from clip coordinates to texture coordinates, after the way from world to
      // unit space.
      glm::dmat4 texture(glm::dmat3(0.5));
      texture[3] = glm::dvec4(0.5, 0.5, 0.5, 1.0);
      vtkNew<vtkDoubleArray> matrix;
      matrix->SetName("BufferFromWorld");
      matrix->SetNumberOfTuples(16);
      const glm::dmat4 rows =
        glm::transpose(texture * (shadowed.BufferFromUnit * space.GetUnitFromWorld()));
      std::copy_n(glm::value_ptr(rows), 16, matrix->GetPointer(0));
      image->GetFieldData()->AddArray(matrix);
      return true;
    }
  }
  return false;
}

void SliceRenderer::ReleaseGraphicsResources(vtkWindow* window)
{
  for (auto& resources : this->Windows)
  {
    if (!window || resources.first == window)
    {
      resources.second->Rasterizer.ReleaseGraphicsResources(resources.first);
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
