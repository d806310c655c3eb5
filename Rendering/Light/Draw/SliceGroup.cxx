// SPDX-License-Identifier: BSD-3-Clause
#include "Draw/SliceGroup.h"

#include "Draw/LightBufferImage.h"
#include "Draw/PicturePlan.h"
#include "Draw/SliceRasterizer.h"
#include "Draw/SliceShader.h"
#include "Loader/OpenGLFunctions.h"
#include "Receivers/SliceScene.h"
#include "Space/BoxCorners.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTimerLog.h"
#include "vtkVolume.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

namespace interlume
{

namespace
{
// How many times the slices that volumes have by themselves are too many for them together.
constexpr double MOST_SLICES = 8.0;

std::array<double, 6> GetBounds(vtkVolume* volume)
{
  std::array<double, 6> bounds{};
  if (const double* found = volume->GetBounds())
  {
    std::copy_n(found, 6, bounds.begin());
  }
  return bounds;
}
}

SliceGroup::SliceGroup() = default;

SliceGroup::~SliceGroup() = default;

void SliceGroup::Clear()
{
  this->Members.clear();
  this->IsDrawn = false;
}

void SliceGroup::Add(
  SliceRenderer* renderer, vtkVolume* volume, const SliceRenderer::Request& request)
{
  this->Members.push_back({ renderer, volume, request, {} });
}

void SliceGroup::Sort()
{
  std::stable_sort(this->Members.begin(), this->Members.end(),
    [](const Member& a, const Member& b) { return GetBounds(a.Volume) < GetBounds(b.Volume); });
}

void SliceGroup::ShareSettings(SliceScene* scene)
{
  vtkShadowedSliceSettings shared = this->Members[0].Request.Settings;
  bool isColored = false;
  bool isAutomatic = false;
  this->LeastBufferSize = 0;
  for (const Member& member : this->Members)
  {
    const vtkShadowedSliceSettings& own = member.Request.Settings;
    shared.MaximumNumberOfShadows =
      std::max(shared.MaximumNumberOfShadows, own.MaximumNumberOfShadows);
    shared.LightLookup = std::max(shared.LightLookup, own.LightLookup);
    shared.ImageSampleDistance = std::min(shared.ImageSampleDistance, own.ImageSampleDistance);
    shared.AutoAdjustSampleDistances =
      shared.AutoAdjustSampleDistances && own.AutoAdjustSampleDistances;
    shared.NumberOfLightSamples = std::max(shared.NumberOfLightSamples, own.NumberOfLightSamples);
    // Layers, before convolution, before the hard shadows of sampled lights.
    const std::array<int, 3> ranks{ { 1, 2, 0 } };
    if (ranks[own.SoftShadowMethod] > ranks[shared.SoftShadowMethod])
    {
      shared.SoftShadowMethod = own.SoftShadowMethod;
    }
    isAutomatic = isAutomatic || own.LightBufferSize == 0;
    this->LeastBufferSize = std::max(this->LeastBufferSize, own.LightBufferSize);
    if (own.MaximumTextureMemory > 0)
    {
      shared.MaximumTextureMemory = shared.MaximumTextureMemory > 0
        ? std::min(shared.MaximumTextureMemory, own.MaximumTextureMemory)
        : own.MaximumTextureMemory;
    }
    isColored = isColored || own.TransmissionColor;
  }
  shared.LightBufferSize = isAutomatic ? 0 : this->LeastBufferSize;
  for (std::size_t i = 0; i < this->Members.size(); ++i)
  {
    Member& member = this->Members[i];
    vtkShadowedSliceSettings& settings = member.Request.Settings;
    shared.SliceSpacing = settings.SliceSpacing;
    shared.SurfaceGradient = settings.SurfaceGradient;
    shared.TwoSidedLighting = settings.TwoSidedLighting;
    shared.TransmissionColor = settings.TransmissionColor;
    shared.MultipleScattering = settings.MultipleScattering;
    shared.ScatteringAlbedo = settings.ScatteringAlbedo;
    shared.PhaseFunction = settings.PhaseFunction;
    shared.Anisotropy = settings.Anisotropy;
    shared.PhaseTable = settings.PhaseTable;
    shared.ForwardSpread = settings.ForwardSpread;
    shared.BackwardLayers = settings.BackwardLayers;
    shared.ScatteringGridSize = settings.ScatteringGridSize;
    shared.ScatteringBrightness = settings.ScatteringBrightness;
    settings = shared;
    member.Request.Scene = scene;
    SliceFrame& frame = member.Renderer->GetFrame();
    frame.Number = static_cast<int>(i);
    frame.HasColoredLight = isColored;
  }
}

void SliceGroup::ShareSpace()
{
  glm::dvec3 lower(std::numeric_limits<double>::max());
  glm::dvec3 upper(-std::numeric_limits<double>::max());
  std::vector<glm::dvec3> places;
  for (const Member& member : this->Members)
  {
    const UnitSpace& space = member.Renderer->GetFrame().Space;
    const BoxCorners corners(space, space.Box);
    for (const glm::dvec3& corner : corners.Get())
    {
      places.push_back(space.Center + space.Radius * corner);
      lower = glm::min(lower, places.back());
      upper = glm::max(upper, places.back());
    }
  }
  const glm::dvec3 center = 0.5 * lower + 0.5 * upper;
  double radius = 0.0;
  for (const glm::dvec3& place : places)
  {
    radius = std::max(radius, Vectors::SafeLength(place - center));
  }
  for (const Member& member : this->Members)
  {
    member.Renderer->MoveTo(member.Request, center, radius);
  }
}

double SliceGroup::ChooseCoarseness() const
{
  if (!this->Members[0].Request.Settings.AutoAdjustSampleDistances)
  {
    return 1.0;
  }
  double allocated = 0.0;
  for (const Member& member : this->Members)
  {
    allocated += member.Volume->GetAllocatedRenderTime();
  }
  return PicturePlan::ChooseCoarseness(this->LastSeconds, this->LastCoarseness, allocated);
}

bool SliceGroup::HasTooManySlices(
  const std::vector<SlicePlan::Matter>& matter, double coarseness) const
{
  const SliceFrame& frame = this->Members[0].Renderer->GetFrame();
  SlicePlan::Settings settings;
  settings.AutomaticFactor = PicturePlan::AutomaticSpacing * coarseness;
  for (const SlicePlan::Sweep& sweep : frame.Plan.Sweeps)
  {
    double alone = 0.0;
    double together = 0.0;
    double finest = std::numeric_limits<double>::max();
    for (const SlicePlan::Matter& volume : matter)
    {
      const std::array<double, 2> range =
        BoxCorners(*volume.Space, volume.Box).GetRange(sweep.Normal);
      const double extent = std::max(range[1] - range[0], 0.0);
      const double spacing =
        SlicePlan::GetSpacing(volume, sweep.Normal, frame.Eye.Direction, settings);
      alone += std::ceil(extent / spacing);
      together += extent / sweep.Spacing;
      finest = std::min(finest, spacing);
    }
    // The largest number of slabs leaves them thicker than asked for.
    if (together > MOST_SLICES * alone || sweep.Spacing > 1.01 * finest)
    {
      return true;
    }
  }
  return false;
}

std::string SliceGroup::MakePlan(double coarseness, vtkShadowedSliceReport& report)
{
  std::vector<SlicePlan::Matter> matter;
  std::vector<const SliceFrame*> frames;
  vtkIdType bytes = 0;
  for (const Member& member : this->Members)
  {
    matter.push_back(member.Renderer->GetMatter(member.Request));
    frames.push_back(&member.Renderer->GetFrame());
    bytes += member.Renderer->GetTextureBytes();
  }
  const vtkShadowedSliceSettings& settings = this->Members[0].Request.Settings;
  SliceFrame& first = this->Members[0].Renderer->GetFrame();
  PicturePlan::Make(first, matter, settings, coarseness, report, this->LeastBufferSize);
  if (this->HasTooManySlices(matter, coarseness))
  {
    return "the finest volume's slices are more than " +
      std::to_string(static_cast<int>(MOST_SLICES)) + " times those of each volume by itself";
  }
  for (std::size_t i = 1; i < this->Members.size(); ++i)
  {
    SliceFrame& frame = this->Members[i].Renderer->GetFrame();
    frame.Plan = first.Plan;
    frame.Lights = first.Lights;
  }
  bytes += PicturePlan::GetBufferBytes(frames);
  if (settings.MaximumTextureMemory > 0 && bytes > settings.MaximumTextureMemory)
  {
    return "textures and buffers of all volumes take " + std::to_string(bytes) +
      " bytes, and the least MaximumTextureMemory is " +
      std::to_string(settings.MaximumTextureMemory);
  }
  return {};
}

std::string SliceGroup::Scatter(vtkRenderer* renderer)
{
  std::vector<SliceScatterer::Matter> matter;
  for (const Member& member : this->Members)
  {
    matter.push_back(member.Renderer->GetScatteringMatter(member.Request));
  }
  std::string error;
  const SliceRenderer* other = nullptr;
  for (Member& member : this->Members)
  {
    if (error.empty())
    {
      error = member.Renderer->UpdateScattering(
        renderer, member.Request, matter, other, member.Result.Report);
    }
    other = member.Renderer->GetFrame().Scattering.HasField() && !other ? member.Renderer : other;
  }
  return error;
}

std::string SliceGroup::DrawMembers(vtkRenderer* renderer, SliceScene* scene)
{
  const double start = vtkTimerLog::GetUniversalTime();
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  this->Sort();
  this->ShareSettings(scene);
  this->ShareSpace();
  const double coarseness = this->ChooseCoarseness();
  vtkShadowedSliceReport shared;
  std::vector<SliceRasterizer::Volume> volumes;
  for (Member& member : this->Members)
  {
    // Faults of lights are the same for all.
    std::vector<std::string> warnings;
    member.Renderer->UpdateView(
      renderer, member.Volume, member.Request, coarseness, warnings, member.Result.Report);
    if (&member == this->Members.data())
    {
      member.Result.Warnings = warnings;
    }
    volumes.push_back({ &member.Renderer->GetFrame(), &member.Renderer->GetTextures(window) });
  }
  std::string error = this->Scatter(renderer);
  error = error.empty() ? this->MakePlan(coarseness, shared) : error;
  for (std::size_t i = 0; i < this->Members.size() && error.empty(); ++i)
  {
    error = this->Members[i].Renderer->Upload(window, this->Members[i].Result.Report);
  }
  if (error.empty())
  {
    std::unique_ptr<SliceRasterizer>& rasterizer = this->Windows[window];
    if (!rasterizer)
    {
      rasterizer = std::make_unique<SliceRasterizer>();
    }
    const auto isAborted = [window]() { return window->CheckAbortStatus() != 0; };
    error = rasterizer->Draw(renderer, volumes, isAborted, shared);
  }
  if (!error.empty())
  {
    return error;
  }
  if (this->Members[0].Request.Settings.AutoAdjustSampleDistances)
  {
    glFinish();
    this->LastSeconds = vtkTimerLog::GetUniversalTime() - start;
  }
  this->LastCoarseness = coarseness;
  shared.Seconds = vtkTimerLog::GetUniversalTime() - start;
  for (Member& member : this->Members)
  {
    const vtkShadowedSliceReport own = member.Result.Report;
    SliceFrame& frame = member.Renderer->GetFrame();
    vtkShadowedSliceReport& report = member.Result.Report;
    report = shared;
    report.Features = SliceShader::GetNames(frame, scene->EyeDepth != nullptr);
    report.ImageSampleDistance = own.ImageSampleDistance;
    report.Blocks = own.Blocks;
    report.BlocksDrawn = own.BlocksDrawn;
    report.NonFiniteVoxels = own.NonFiniteVoxels;
    report.TextureBytes = own.TextureBytes;
    report.UploadedBytes += own.UploadedBytes;
    report.ScatteringCells = own.ScatteringCells;
    report.ScatteringBlockedCells = own.ScatteringBlockedCells;
    report.ScatteringBytes = own.ScatteringBytes;
    report.ScatteringSolves = own.ScatteringSolves;
    report.ScatteringSeconds = own.ScatteringSeconds;
    // What one volume has scattered is found in the matter of all, so that it counts once.
    if (scene->Fields.empty())
    {
      member.Renderer->AddField(window, *scene);
    }
    // Nothing of a picture by itself is kept.
    member.Renderer->ReleasePicture(window);
  }
  const SliceFrame& first = this->Members[0].Renderer->GetFrame();
  this->Plan = first.Plan;
  this->Lights = first.Lights;
  this->Space = first.Space;
  this->IsDrawn = true;
  this->IsShown = false;
  return {};
}

std::string SliceGroup::Draw(vtkRenderer* renderer, SliceScene* scene)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  std::set<SliceRenderer*> renderers;
  for (const Member& member : this->Members)
  {
    renderers.insert(member.Renderer);
  }
  std::string error =
    renderers.size() < this->Members.size() ? "one mapper draws several volumes" : "";
  if (error.empty())
  {
    this->Members.erase(
      std::remove_if(this->Members.begin(), this->Members.end(),
        [window](const Member& member)
        { return !member.Renderer->UpdateVolume(window, member.Volume, member.Request).empty(); }),
      this->Members.end());
    if (this->Members.size() > 1)
    {
      error = this->DrawMembers(renderer, scene);
    }
  }
  for (const Member& member : this->Members)
  {
    // The scene is gone when the picture has been drawn.
    member.Renderer->GetFrame().Scene = nullptr;
  }
  if (!this->IsDrawn)
  {
    this->Members.clear();
    this->ReleaseGraphicsResources(window);
  }
  return error;
}

const SliceGroup::Share* SliceGroup::Find(const SliceRenderer* renderer) const
{
  const auto found = std::find_if(this->Members.begin(), this->Members.end(),
    [renderer](const Member& member) { return member.Renderer == renderer; });
  return this->IsDrawn && found != this->Members.end() ? &found->Result : nullptr;
}

void SliceGroup::Show(vtkRenderer* renderer)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  const auto rasterizer = this->Windows.find(window);
  if (window && rasterizer != this->Windows.end() && !this->IsShown)
  {
    rasterizer->second->Show(window);
    this->IsShown = true;
  }
}

bool SliceGroup::ReadLightBuffer(vtkRenderer* renderer, vtkLight* light, vtkImageData* image)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  const auto rasterizer = this->Windows.find(window);
  return this->IsDrawn && rasterizer != this->Windows.end() &&
    LightBufferImage::Read(
      *rasterizer->second, { this->Plan, this->Lights, this->Space }, window, light, image);
}

void SliceGroup::ReleaseGraphicsResources(vtkWindow* window)
{
  for (auto& rasterizer : this->Windows)
  {
    if (!window || rasterizer.first == window)
    {
      rasterizer.second->ReleaseGraphicsResources(rasterizer.first);
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
