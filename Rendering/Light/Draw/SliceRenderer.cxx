// SPDX-License-Identifier: BSD-3-Clause
#include "Draw/SliceRenderer.h"

#include "Common/Vectors.h"
#include "Draw/SlicePlanner.h"
#include "Draw/VolumeResources.h"
#include "Lights/LightSources.h"
#include "Loader/OpenGLFunctions.h"
#include "Loader/SoftwareOpenGL.h"
#include "Offscreen/SceneDepth.h"
#include "Receivers/SliceScene.h"
#include "Refinement/RenderProgress.h"
#include "Shaders/SliceShader.h"
#include "Space/BoxCorners.h"
#include "Space/UnitVector.h"
#include "Sweeps/SliceRasterizer.h"
#include "Sweeps/SliceReport.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkLightCollection.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointData.h"
#include "vtkRenderer.h"
#include "vtkSMPTools.h"
#include "vtkSliceMedium.h"
#include "vtkTimerLog.h"
#include "vtkVolume.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace interlume
{

namespace
{
// Maximum ratio of the number of slices needed to render volumes together to the number needed to
// render them separately.
constexpr double MAXIMUM_SLICE_RATIO = 8.0;
/// Estimated time per pixel, slice, and light or image, of software OpenGL with one thread, and of
/// a GPU.
constexpr double SOFTWARE_SECONDS = 2e-8;
constexpr double GPU_SECONDS = 1e-10;

std::array<double, 6> GetBounds(const VolumeResources* volume)
{
  std::array<double, 6> bounds{};
  if (const double* found = volume->GetRequest().Volume->GetBounds())
  {
    std::copy_n(found, 6, bounds.begin());
  }
  return bounds;
}

// Returns the camera in unit space.
SlicePlan::Camera FindCamera(vtkRenderer* renderer, const UnitSpace& space)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  const auto fromRows = [](vtkMatrix4x4* matrix)
  { return UnitVector::FromRows(matrix->GetData()); };
  SlicePlan::Camera eye;
  // Multiply matrices in double precision before transforming coordinates.
  eye.ClipFromUnit =
    fromRows(camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1.0, 1.0)) *
    (fromRows(camera->GetModelViewTransformMatrix()) * space.GetWorldFromUnit());
  const glm::dmat4 inverse = glm::inverse(eye.ClipFromUnit);

  eye.IsParallel = camera->GetParallelProjection() != 0;
  // The camera position is the intersection of all view rays, even in sheared stereo views.
  const glm::dvec4 apex = inverse * glm::dvec4(0.0, 0.0, -1.0, 0.0);
  const glm::dvec4 near = inverse * glm::dvec4(0.0, 0.0, -1.0, 1.0);
  const glm::dvec4 far = inverse * glm::dvec4(0.0, 0.0, 1.0, 1.0);
  const glm::dvec3 forward = glm::dvec3(far) / far.w - glm::dvec3(near) / near.w;
  eye.Direction = forward / glm::length(forward);
  eye.Position =
    eye.IsParallel ? glm::dvec3(near) / near.w - 4.0 * eye.Direction : glm::dvec3(apex) / apex.w;
  return eye;
}

// Returns the near (sign 1) or far (sign -1) clipping plane in unit space.
ImageState::ViewPlane MakeViewPlane(const glm::dmat4& clipFromUnit, double sign)
{
  const glm::dvec4 plane = glm::row(clipFromUnit, 3) + sign * glm::row(clipFromUnit, 2);
  const glm::dvec4 scaled = plane / glm::length(glm::dvec3(plane));
  // The volumes are inside the unit sphere, so a plane at a distance of 1 or more cuts none of
  // them.
  return { scaled.w < 1.0, { { scaled.x, scaled.y, scaled.z, scaled.w } } };
}

// Returns the sum of the lights' ambient colors, or white if the sum is black.
glm::dvec3 FindAmbient(const std::vector<LightSource>& lights)
{
  glm::dvec3 ambient(0.0);
  for (const LightSource& light : lights)
  {
    ambient += light.Ambient;
  }
  return ambient.x + ambient.y + ambient.z == 0.0 ? glm::dvec3(1.0) : ambient;
}
}

SliceRenderer::SliceRenderer() = default;

SliceRenderer::~SliceRenderer() = default;

SliceRenderer::Volumes SliceRenderer::UpdateVolumes(
  vtkOpenGLRenderWindow* window, const Volumes& volumes)
{
  Volumes updated;
  this->Settings = ImageSettings();
  for (VolumeResources* volume : volumes)
  {
    Error& error = volume->GetResult().Error;
    error = volume->UpdateData(window);
    if (!error)
    {
      updated.push_back(volume);
      this->Settings.Add(volume->GetRequest().Settings);
    }
  }
  std::stable_sort(updated.begin(), updated.end(),
    [](const VolumeResources* a, const VolumeResources* b) { return GetBounds(a) < GetBounds(b); });
  if (updated.size() > 1)
  {
    this->MoveToSharedSpace(updated);
  }
  for (std::size_t i = 0; i < updated.size(); ++i)
  {
    updated[i]->SetImage(this->Image, static_cast<int>(i));
  }
  return updated;
}

void SliceRenderer::MoveToSharedSpace(const Volumes& volumes)
{
  glm::dvec3 lower(std::numeric_limits<double>::max());
  glm::dvec3 upper(-std::numeric_limits<double>::max());
  std::vector<glm::dvec3> points;
  for (const VolumeResources* volume : volumes)
  {
    const UnitSpace& space = volume->GetState().Space;
    const BoxCorners corners(space, space.Box);
    for (const glm::dvec3& corner : corners.Get())
    {
      points.push_back(space.Center + space.Radius * corner);
      lower = glm::min(lower, points.back());
      upper = glm::max(upper, points.back());
    }
  }
  const glm::dvec3 center = 0.5 * lower + 0.5 * upper;
  double radius = 0.0;
  for (const glm::dvec3& point : points)
  {
    radius = std::max(radius, Vectors::SafeLength(point - center));
  }
  for (VolumeResources* volume : volumes)
  {
    volume->MoveTo(center, radius);
  }
}

double SliceRenderer::ChooseCoarseness(const Volumes& volumes) const
{
  if (!this->Settings.AutoAdjustSampleDistances)
  {
    return 1.0;
  }
  double allocated = 0.0;
  for (const VolumeResources* volume : volumes)
  {
    allocated += volume->GetRequest().Volume->GetAllocatedRenderTime();
  }
  return PassTimes::ChooseCoarseness(this->LastSeconds, this->LastCoarseness, allocated);
}

double SliceRenderer::BeginPass(vtkRenderer* renderer, const VolumeResources& volume)
{
  const VolumeResources::Request& request = volume.GetRequest();
  std::array<int, 2> size{};
  std::array<int, 2> origin{};
  renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
  const int* dimensions = request.Image->GetDimensions();
  const double samples = *std::max_element(dimensions, dimensions + 3) /
    SlicePlanner::AutomaticSpacing * size[0] * size[1] *
    (1.0 + renderer->GetLights()->GetNumberOfItems());
  const bool isSoftware =
    SoftwareOpenGL::IsUsed(vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()));
  const double estimate = samples *
    (isSoftware ? SOFTWARE_SECONDS / vtkSMPTools::GetEstimatedNumberOfThreads() : GPU_SECONDS);
  ImageKey key(renderer, request.Volume, request.Volume->GetMapper());
  key.Add(request.Scalars);
  key.Add(request.Medium);
  return this->Refinement.Begin(renderer, request.Volume, key,
    this->Times.GetFinalSeconds(size, estimate), request.Volume->GetAllocatedRenderTime());
}

void SliceRenderer::UpdateView(vtkRenderer* renderer, const Volumes& volumes, double coarseness,
  SliceScene* scene, SliceReport& report)
{
  ImageState& image = this->Image;
  this->Space = volumes[0]->GetState().Space;
  report.ImageSampleDistance = this->Settings.ImageSampleDistance * coarseness;
  int width = 0;
  int height = 0;
  int left = 0;
  int bottom = 0;
  renderer->GetTiledSizeAndOrigin(&width, &height, &left, &bottom);
  const auto toPixels = [&report](int size)
  { return std::max(static_cast<int>(std::lround(size / report.ImageSampleDistance)), 1); };
  image.Size = { { toPixels(width), toPixels(height) } };
  image.Camera = FindCamera(renderer, this->Space);
  image.NearPlane = MakeViewPlane(image.Camera.ClipFromUnit, 1.0);
  image.FarPlane = MakeViewPlane(image.Camera.ClipFromUnit, -1.0);
  image.Lights = LightSources::Gather(renderer, this->Space,
    { this->Settings.HasShadows && !renderer->GetSelector(),
      this->Settings.MaximumNumberOfShadowLights },
    volumes[0]->GetResult().Warnings);
  image.Ambient = FindAmbient(image.Lights);
  image.IsSmoothLookup = this->Settings.IsSmoothLookup;
  image.HasColoredLight = this->Settings.HasColoredLight;
  image.Scene = scene;
  image.MayBeOccluded = SceneDepth::MayOcclude(renderer, volumes[0]->GetRequest().Volume);
}

bool SliceRenderer::HasTooManySlices(
  const std::vector<SlicePlan::SlicedVolume>& volumes, double coarseness) const
{
  SlicePlan::Settings settings;
  settings.AutomaticFactor = SlicePlanner::AutomaticSpacing * coarseness;
  for (const SlicePlan::Sweep& sweep : this->Image.Plan.Sweeps)
  {
    double separate = 0.0;
    double together = 0.0;
    double finest = std::numeric_limits<double>::max();
    for (const SlicePlan::SlicedVolume& volume : volumes)
    {
      const std::array<double, 2> range =
        BoxCorners(*volume.Space, volume.Box).GetRange(sweep.Normal);
      const double extent = std::max(range[1] - range[0], 0.0);
      const double spacing =
        SlicePlan::GetSpacing(volume, sweep.Normal, this->Image.Camera.Direction, settings);
      separate += std::ceil(extent / spacing);
      together += extent / sweep.Spacing;
      finest = std::min(finest, spacing);
    }
    // The limit on the number of slabs can make slabs thicker than requested.
    if (together > MAXIMUM_SLICE_RATIO * separate || sweep.Spacing > 1.01 * finest)
    {
      return true;
    }
  }
  return false;
}

Error SliceRenderer::MakePlan(const Volumes& volumes, double coarseness, SliceReport& report)
{
  std::vector<SlicePlan::SlicedVolume> sliced;
  std::vector<const VolumeRenderState*> states;
  vtkIdType bytes = 0;
  for (const VolumeResources* volume : volumes)
  {
    sliced.push_back(volume->GetSlicedVolume());
    sliced.back().Spacing *= this->Settings.Coarseness;
    states.push_back(&volume->GetState());
    bytes += volume->GetTextureBytes();
  }
  SlicePlanner::Make(this->Image, states, sliced, this->Settings, coarseness, report);
  if (volumes.size() > 1 && this->HasTooManySlices(sliced, coarseness))
  {
    return "Rendering the volumes together requires more than " +
      std::to_string(static_cast<int>(MAXIMUM_SLICE_RATIO)) +
      " times as many slices as rendering them separately. Increase the SliceSpacing of the "
      "volume with the finest slices.";
  }
  bytes += SlicePlanner::GetBufferBytes(this->Image, states);
  if (this->Settings.MaximumTextureMemory > 0 && bytes > this->Settings.MaximumTextureMemory)
  {
    return Error("The textures and buffers of the volumes need " + std::to_string(bytes) +
        " bytes, but MaximumTextureMemory is " +
        std::to_string(this->Settings.MaximumTextureMemory) +
        ". Increase it or use smaller volumes.",
      ErrorCode::OutOfMemory);
  }
  return {};
}

Error SliceRenderer::UpdateScattering(vtkRenderer* renderer, const Volumes& volumes)
{
  std::vector<ScatteringUpdater::Volume> media;
  for (const VolumeResources* volume : volumes)
  {
    media.push_back(volume->GetScatteringVolume());
  }
  const VolumeResources* other = nullptr;
  for (VolumeResources* volume : volumes)
  {
    if (Error error =
          volume->UpdateScattering(renderer, media, this->Settings.NumberOfLightSamples, other))
    {
      return error;
    }
    other = volume->GetState().Scattering.HasMaps() && !other ? volume : other;
  }
  return {};
}

Error SliceRenderer::DrawSlices(vtkRenderer* renderer, const Volumes& volumes, SliceReport& report)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  std::vector<SliceRasterizer::Volume> drawn;
  for (VolumeResources* volume : volumes)
  {
    if (Error error = volume->Upload(window))
    {
      return error;
    }
    drawn.push_back({ &volume->GetState(), &volume->GetTextures(window) });
  }
  std::unique_ptr<SliceRasterizer>& rasterizer = this->Windows[window];
  if (!rasterizer)
  {
    rasterizer = std::make_unique<SliceRasterizer>();
  }
  RenderProgress progress(window, volumes[0]->GetRequest().Volume->GetMapper());
  Error error = rasterizer->Draw(renderer, this->Image, drawn, progress, report);
  for (std::size_t i = 0; i < volumes.size() && !error && this->Image.Scene; ++i)
  {
    // The scattered light of one volume is computed from the media of all volumes, so it must be
    // added only once.
    if (volumes[i]->AddScatteredLight(window))
    {
      break;
    }
  }
  return error;
}

Error SliceRenderer::Draw(vtkRenderer* renderer, const Volumes& volumes, SliceScene* scene)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  this->IsShown = false;
  Error error = SliceRasterizer::FindError(window);
  const bool isSelection = renderer->GetSelector() != nullptr;
  this->IsRefined = !error && !scene && !isSelection && volumes.size() == 1 &&
    volumes[0]->GetRequest().Settings.ProgressiveRendering;
  const double seconds = this->IsRefined ? this->BeginPass(renderer, *volumes[0]) : 0.0;
  if (this->IsRefined && seconds == ImageRefinement::REUSED)
  {
    volumes[0]->ReuseReport();
    return {};
  }
  error = error.Then([&] { return this->DrawPass(renderer, volumes, seconds, scene); });
  if (isSelection)
  {
    // The selection overwrites the image.
    this->Refinement.DropImage();
  }
  else if (!this->IsRefined && this->SampleVolume)
  {
    this->SampleVolume->ReleaseGraphicsResources(window);
    this->SampleVolume.reset();
    this->Sample = ImageSample();
  }
  if (error || (!this->IsRefined && !isSelection))
  {
    this->Refinement.Clear();
  }
  return error;
}

Error SliceRenderer::DrawPass(
  vtkRenderer* renderer, const Volumes& volumes, double seconds, SliceScene* scene)
{
  const double start = vtkTimerLog::GetUniversalTime();
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  Volumes drawn = this->IsRefined ? this->UpdateSample(window, *volumes[0], seconds) : Volumes();
  const bool isSample = !drawn.empty();
  this->VoxelStride = isSample ? this->Sample.GetStride() : 1;
  if (!isSample)
  {
    drawn = this->UpdateVolumes(window, volumes);
  }
  if (drawn.empty())
  {
    this->Refinement.Clear();
    return {};
  }
  Error error = this->DrawUpdated(renderer, drawn,
    this->IsRefined ? this->Times.Choose(seconds) : this->ChooseCoarseness(drawn), scene, start);
  if (isSample)
  {
    volumes[0]->CopyReport(*drawn[0]);
  }
  return error;
}

SliceRenderer::Volumes SliceRenderer::UpdateSample(
  vtkOpenGLRenderWindow* window, const VolumeResources& volume, double seconds)
{
  VolumeResources::Request request = volume.GetRequest();
  if (seconds > ImageRefinement::FIRST_SECONDS || request.Medium || request.IsOfCells ||
    request.Image->GetNumberOfPoints() <= 8 * ImageSample::SIZE || volume.IsCurrent())
  {
    return {};
  }
  this->Sample.Update(request.Image, request.Scalars);
  request.Image = this->Sample.GetImage();
  request.Scalars = request.Image->GetPointData()->GetScalars();
  if (!this->SampleVolume)
  {
    this->SampleVolume = std::make_unique<VolumeResources>();
  }
  this->SampleVolume->SetRequest(request, {});
  return this->UpdateVolumes(window, { this->SampleVolume.get() });
}

Error SliceRenderer::DrawUpdated(
  vtkRenderer* renderer, const Volumes& volumes, double coarseness, SliceScene* scene, double start)
{
  const double updated = vtkTimerLog::GetUniversalTime();
  SliceReport report;
  this->UpdateView(renderer, volumes, coarseness, scene, report);
  Error error = this->UpdateScattering(renderer, volumes);
  const double sliceCoarseness = std::max(coarseness / this->VoxelStride, 1.0);
  if (this->IsRefined && coarseness > 1.0)
  {
    this->Settings.Coarsen(sliceCoarseness);
  }
  error = error.Then([&] { return this->MakePlan(volumes, sliceCoarseness, report); })
            .Then([&] { return this->DrawSlices(renderer, volumes, report); });
  if (!error && this->Find(renderer)->IsComplete())
  {
    this->AddTimes(coarseness, start, updated);
  }
  report.Seconds = vtkTimerLog::GetUniversalTime() - start;
  for (VolumeResources* volume : volumes)
  {
    volume->SetReport(report,
      error ? std::string()
            : SliceShader::GetNames(volume->GetState(), this->Find(renderer)->IsOccluded()));
  }
  // The scene is valid only during this call.
  this->Image.Scene = nullptr;
  return error;
}

void SliceRenderer::AddTimes(double coarseness, double start, double updated)
{
  if (this->Settings.AutoAdjustSampleDistances || this->IsRefined)
  {
    glFinish();
  }
  const double now = vtkTimerLog::GetUniversalTime();
  if (this->IsRefined)
  {
    const bool isFinal = coarseness == 1.0 && this->VoxelStride == 1;
    if (isFinal || coarseness > 1.0)
    {
      this->Times.Add(coarseness, now - updated);
    }
    this->Refinement.End(isFinal);
  }
  if (this->Settings.AutoAdjustSampleDistances)
  {
    // The time of a coarse pass is mostly overhead, so the time of a complete image does not follow
    // from it. Otherwise, the next complete image could be coarse.
    this->LastCoarseness = this->IsRefined ? 1.0 : coarseness;
    this->LastSeconds = this->IsRefined ? this->Times.GetFinalSeconds() : now - start;
  }
}

SliceRasterizer* SliceRenderer::Find(vtkRenderer* renderer) const
{
  const auto found = this->Windows.find(renderer->GetRenderWindow());
  return found == this->Windows.end() ? nullptr : found->second.get();
}

void SliceRenderer::Show(vtkRenderer* renderer)
{
  SliceRasterizer* rasterizer = this->Find(renderer);
  if (!rasterizer || this->IsShown)
  {
    return;
  }
  rasterizer->Show(renderer);
  this->IsShown = true;
}

bool SliceRenderer::ReadLightBuffer(vtkRenderer* renderer, vtkLight* light, vtkImageData* image)
{
  SliceRasterizer* rasterizer = this->Find(renderer);
  return rasterizer &&
    rasterizer->ReadLightBuffer(vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()),
      this->Image, this->Space, light, image);
}

void SliceRenderer::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Refinement.DropImage();
  if (this->SampleVolume)
  {
    this->SampleVolume->ReleaseGraphicsResources(window);
  }
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
