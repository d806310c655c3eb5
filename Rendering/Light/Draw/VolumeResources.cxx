// SPDX-License-Identifier: BSD-3-Clause
#include "Draw/VolumeResources.h"

#include "Common/Vectors.h"
#include "Loader/SoftwareOpenGL.h"
#include "Receivers/SliceScene.h"
#include "Shaders/SliceShader.h"
#include "Shaders/SliceTextures.h"
#include "Volume/OccupancyEstimate.h"

#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPiecewiseFunction.h"
#include "vtkProjectiveLight.h"
#include "vtkRenderer.h"
#include "vtkSliceMedium.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <utility>

namespace interlume
{

struct VolumeResources::WindowResources
{
  SliceTextures Textures;
  int SamplesVersion = 0;
  /// Version of the samples whose differences are in the texture, or 0.
  int DifferencesVersion = 0;
  int MaterialVersion = 0;
  int ScatteringVersion = 0;
};

namespace
{
// Largest texture of differences. Larger volumes are drawn more slowly.
constexpr vtkIdType MaximumDifferenceBytes = 1 << 28;

double GetTime(vtkObject* function)
{
  return function ? static_cast<double>(function->GetMTime()) : 0.0;
}

// Returns all inputs of a material except the samples. The property's own modification time cannot
// be used: it also changes when the property is assigned to a volume or when its shading changes.
std::vector<double> MakeKey(vtkVolumeProperty* property, int components,
  vtkColorTransferFunction* transmission, const MaterialTable::Scattering& scattering)
{
  std::vector<double> key{ static_cast<double>(property->GetIndependentComponents()),
    static_cast<double>(property->GetTransferFunctionMode()), GetTime(transmission),
    scattering.IsOn ? 1.0 : 0.0, GetTime(scattering.Albedo) };
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
    // GetGradientOpacity would create a function if it is missing or disabled.
    const bool hasGradient =
      property->HasGradientOpacity(row) && property->GetDisableGradientOpacity(row) == 0;
    vtkObject* gradient = hasGradient ? property->GetGradientOpacity(row) : nullptr;
    key.insert(key.end(),
      { static_cast<double>(channels), hasGradient ? 1.0 : 0.0,
        property->GetScalarOpacityUnitDistance(row), property->GetComponentWeight(row),
        GetTime(color), GetTime(property->GetScalarOpacity(row)), GetTime(gradient) });
  }
  return key;
}

// Returns the number of samples along each axis.
std::array<int, 3> GetSize(const VolumeResources::Request& request)
{
  std::array<int, 3> size{};
  const int* dimensions = request.Image->GetDimensions();
  for (int axis = 0; axis < 3; ++axis)
  {
    size[axis] = request.IsOfCells ? std::max(dimensions[axis] - 1, 1) : dimensions[axis];
  }
  return size;
}

MaterialTable::Scattering GetScattering(const VolumeResources::Request& request)
{
  MaterialTable::Scattering scattering;
  scattering.IsOn = request.Settings.ScatteringMode != vtkShadowedSliceSettings::NO_SCATTERING;
  scattering.Albedo = scattering.IsOn ? request.Settings.ScatteringAlbedo.Get() : nullptr;
  return scattering;
}
}

VolumeResources::VolumeResources() = default;

VolumeResources::~VolumeResources() = default;

void VolumeResources::SetRequest(const Request& request, const Error& error)
{
  this->CurrentRequest = request;
  this->Results = Result();
  this->Results.Error = error;
  this->PreviousReport = this->Report;
  this->Report = SliceReport();
  this->UploadedBytes = 0;
}

bool VolumeResources::HasCurrentSamples() const
{
  const Request& request = this->CurrentRequest;
  // Compare the size too: two vtkImageData objects can share an array that was modified after both.
  return this->Scalars == request.Scalars &&
    this->SamplesTime == std::max(request.Image->GetMTime(), request.Scalars->GetMTime()) &&
    this->State.Samples.Size == GetSize(request) && this->IsWidened == this->State.IsSoftware;
}

std::vector<double> VolumeResources::MakeMaterialKey() const
{
  const Request& request = this->CurrentRequest;
  return MakeKey(request.Volume->GetProperty(), this->State.Samples.Components,
    request.Settings.TransmissionColor, GetScattering(request));
}

bool VolumeResources::IsCurrent() const
{
  return this->HasCurrentSamples() &&
    this->MaterialOwner == this->CurrentRequest.Volume->GetProperty() &&
    this->MaterialKey == this->MakeMaterialKey();
}

Error VolumeResources::UpdateSamples()
{
  const Request& request = this->CurrentRequest;
  const bool isSoftware = this->State.IsSoftware;
  if (this->HasCurrentSamples())
  {
    return {};
  }
  this->Scalars = nullptr;
  this->MaterialOwner = nullptr;
  if (Error error = this->State.Samples.Build(request.Scalars, GetSize(request), isSoftware))
  {
    return error;
  }
  this->State.SmallBlocks = VolumeBlocks();
  if (isSoftware)
  {
    this->State.SmallBlocks.Build(this->State.Samples, VolumeBlocks::SmallSize);
    this->State.Blocks.Join(this->State.SmallBlocks);
  }
  else
  {
    this->State.Blocks.Build(this->State.Samples);
  }
  this->Scalars = request.Scalars;
  this->SamplesTime = std::max(request.Image->GetMTime(), request.Scalars->GetMTime());
  this->IsWidened = isSoftware;
  ++this->SamplesVersion;
  return {};
}

Error VolumeResources::UpdateMaterial()
{
  const Request& request = this->CurrentRequest;
  vtkVolumeProperty* property = request.Volume->GetProperty();
  std::vector<double> key = this->MakeMaterialKey();
  if (this->MaterialOwner == property && this->MaterialKey == key)
  {
    return {};
  }
  this->MaterialOwner = nullptr;
  if (Error error = this->State.Material.Build(
        property, this->State.Samples, request.Settings.TransmissionColor, GetScattering(request)))
  {
    return error;
  }
  this->State.Blocks.Classify(this->State.Material);
  this->State.SmallBlocks.Classify(this->State.Material);
  this->State.OccupiedFraction =
    OccupancyEstimate::Find(this->State.Samples, this->State.Blocks, this->State.Material);
  this->MaterialOwner = property;
  this->MaterialKey = std::move(key);
  ++this->MaterialVersion;
  return {};
}

SliceTextures& VolumeResources::GetTextures(vtkWindow* window)
{
  return this->Windows[window]->Textures;
}

vtkIdType VolumeResources::GetTextureBytes() const
{
  if (this->State.Medium)
  {
    return SliceTextures::GetBytes(this->State.Scattering);
  }
  return SliceTextures::GetBytes(this->State.Samples) +
    (this->State.HasDifferences ? SliceTextures::GetDifferenceBytes(this->State.Samples) : 0) +
    SliceTextures::GetBytes(this->State.Material) + SliceTextures::GetBytes(this->State.Scattering);
}

Error VolumeResources::Upload(vtkOpenGLRenderWindow* window)
{
  WindowResources& resources = *this->Windows[window];
  const VolumeRenderState& frame = this->State;
  SliceTextures& textures = resources.Textures;
  Error error;
  const auto upload = [&](const auto& data, int version, int& uploadedVersion)
  {
    if (!error && uploadedVersion != version)
    {
      error = textures.Upload(window, data);
      uploadedVersion = error ? 0 : version;
      this->UploadedBytes += SliceTextures::GetBytes(data);
    }
  };
  textures.SetMedium(frame.Medium);
  if (!frame.Medium)
  {
    upload(frame.Samples, this->SamplesVersion, resources.SamplesVersion);
    upload(frame.Material, this->MaterialVersion, resources.MaterialVersion);
  }
  const int differences = frame.HasDifferences ? this->SamplesVersion : 0;
  if (!error && resources.DifferencesVersion != differences)
  {
    error = textures.UploadDifferences(window, differences > 0 ? &frame.Samples : nullptr);
    resources.DifferencesVersion = error ? 0 : differences;
    this->UploadedBytes += differences > 0 ? SliceTextures::GetDifferenceBytes(frame.Samples) : 0;
  }
  upload(frame.Scattering, this->Scatterer.GetVersion(), resources.ScatteringVersion);
  std::vector<vtkProjectiveLight*> screens;
  for (const LightSource& light : frame.Image->Lights)
  {
    if (light.Projective && light.Projective->GetImage())
    {
      screens.push_back(light.Projective);
    }
  }
  textures.GetScreens().Keep(screens, window);
  return error;
}

bool VolumeResources::AddScatteredLight(vtkOpenGLRenderWindow* window)
{
  const SliceScattering& scattering = this->State.Scattering;
  if (!scattering.HasMaps())
  {
    return false;
  }
  ScatteredLightTexture field;
  field.Texture = this->GetTextures(window).GetScatteredLightTexture();
  field.Nodes = scattering.Nodes;
  field.NodeFromWorld = scattering.NodeFromUnit * this->State.Space.GetUnitFromWorld();
  field.HasFluence = scattering.HasFluence;
  field.BlockedCells = this->Scatterer.GetBlockedCells();
  const std::vector<LightSource>& lights = this->State.Image->Lights;
  for (const vtkLight* known : scattering.ForwardLights)
  {
    const auto light = std::find_if(lights.begin(), lights.end(),
      [known](const LightSource& source) { return source.Light == known; });
    field.Lights.push_back(light->Light);
  }
  this->State.Image->Scene->Fields.push_back(field);
  return true;
}

Error VolumeResources::UpdateData(vtkOpenGLRenderWindow* window)
{
  std::unique_ptr<WindowResources>& resources = this->Windows[window];
  if (!resources)
  {
    resources = std::make_unique<WindowResources>();
  }
  VolumeRenderState& state = this->State;
  state.IsSoftware = SoftwareOpenGL::IsUsed(window);
  state.Medium = this->CurrentRequest.Medium;
  // Gradient magnitudes do not depend on the sign of the spacing.
  const glm::dvec3 spacing = glm::abs(glm::make_vec3(this->CurrentRequest.Image->GetSpacing()));
  state.GradientSteps = (spacing.x + spacing.y + spacing.z) / 3.0 / spacing;
  const Request& request = this->CurrentRequest;
  return this->UpdateSamples()
    .Then([&] { return this->UpdateMaterial(); })
    .Then([&] { return this->Scatterer.SetPhase(request.Settings, state.Scattering); })
    .Then([&]
      { return state.Space.Set(request.Image, request.IsOfCells, request.Volume->GetMatrix()); })
    .Then([&] { return state.Region.Set(request.Cuts, state.Space); });
}

void VolumeResources::MoveTo(const glm::dvec3& center, double radius)
{
  this->State.Space.MoveTo(center, radius);
  // Ignore errors of clipping planes: UpdateData has reported them.
  static_cast<void>(this->State.Region.Set(this->CurrentRequest.Cuts, this->State.Space));
}

void VolumeResources::SetImage(const ImageState& image, int number)
{
  VolumeRenderState& state = this->State;
  state.Image = &image;
  state.Number = number;
  state.SurfaceGradient = this->CurrentRequest.Settings.SurfaceGradient;
  state.TwoSidedLighting = this->CurrentRequest.Settings.TwoSidedLighting;
  vtkVolumeProperty* property = this->CurrentRequest.Volume->GetProperty();
  state.IsShaded = property->GetShade() != 0 && !state.Scattering.IsOn() &&
    (!state.Medium || state.Medium->HasReflection());
  // In software, one lookup of three differences is faster than six lookups of values.
  state.HasDifferences = state.IsSoftware && !state.Medium && state.Samples.Components == 1 &&
    state.Samples.Mask.empty() && (state.IsShaded || !state.Material.GradientOpacity.empty()) &&
    this->CurrentRequest.Settings.MaximumTextureMemory == 0 &&
    SliceTextures::GetDifferenceBytes(state.Samples) <= MaximumDifferenceBytes;
  for (int row = 0; row < state.Material.Rows; ++row)
  {
    state.Materials[row] = { { static_cast<float>(property->GetAmbient(row)),
      static_cast<float>(property->GetDiffuse(row)), static_cast<float>(property->GetSpecular(row)),
      static_cast<float>(property->GetSpecularPower(row)) } };
    state.UnitDistances[row] = property->GetScalarOpacityUnitDistance(row);
  }
}

ScatteringUpdater::Volume VolumeResources::GetScatteringVolume() const
{
  return { &this->State, { { this->SamplesVersion, this->MaterialVersion } },
    this->CurrentRequest.Settings.ScatteringGridSize };
}

Error VolumeResources::UpdateScattering(vtkRenderer* renderer,
  const std::vector<ScatteringUpdater::Volume>& volumes, int lightSamples,
  const VolumeResources* other)
{
  // A selection is drawn without lights, so keep the scattered light unchanged.
  return renderer->GetSelector()
    ? Error()
    : this->Scatterer.Solve(vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()),
        this->State, volumes, this->CurrentRequest.Settings, lightSamples,
        other ? &other->Scatterer : nullptr, other ? &other->State.Scattering : nullptr);
}

SlicePlan::SlicedVolume VolumeResources::GetSlicedVolume() const
{
  return { &this->State.Space, this->State.Region.Box,
    this->CurrentRequest.Settings.SliceSpacing / this->State.Space.Radius,
    this->State.Material.HasSharpOpacity() ? 0.0 : SliceShader::GetRampExtinction(this->State) };
}

void VolumeResources::SetReport(const SliceReport& shared, const std::string& features)
{
  this->Report = shared;
  this->Report.Features = features;
  this->Report.Blocks = this->State.Blocks.GetNumberOfBlocks();
  this->Report.BlocksDrawn = this->State.Blocks.GetNumberOfVisibleBlocks();
  this->Report.NonFiniteVoxels = this->State.Samples.NonFinite;
  this->Report.TextureBytes = this->GetTextureBytes();
  this->Report.UploadedBytes += this->UploadedBytes;
  this->Scatterer.Fill(this->Report);
  this->Report.ScatteringBytes =
    static_cast<vtkIdType>(sizeof(float) * this->State.Scattering.Texels.size());
}

void VolumeResources::ReuseReport()
{
  this->Report = this->PreviousReport;
  for (int* passes : { &this->Report.SlicesDrawn, &this->Report.ImagePasses,
         &this->Report.LightPasses, &this->Report.OcclusionPasses, &this->Report.SoftShadowPasses })
  {
    *passes = 0;
  }
  this->Report.UploadedBytes = 0;
  this->Report.TriangleBytes = 0;
  this->Report.Seconds = 0.0;
}

void VolumeResources::ReleaseGraphicsResources(vtkWindow* window)
{
  for (auto& resources : this->Windows)
  {
    if (!window || resources.first == window)
    {
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
