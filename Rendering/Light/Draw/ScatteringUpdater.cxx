// SPDX-License-Identifier: BSD-3-Clause
#include "Draw/ScatteringUpdater.h"

#include "Common/Vectors.h"
#include "Draw/SurfaceOcclusionGrid.h"
#include "Grid/ScatteredLightMaps.h"
#include "Grid/GridLight.h"
#include "Scattering/ScatteringSolver.h"
#include "Shaders/VolumeRenderState.h"
#include "Sweeps/SliceReport.h"

#include "vtkAreaLight.h"
#include "vtkMath.h"
#include "vtkPiecewiseFunction.h"
#include "vtkProjectiveLight.h"
#include "vtkTimerLog.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace interlume
{

using Settings = vtkShadowedSliceSettings;

namespace
{
// Default number of grid cells along a volume's longest edge.
constexpr int AutomaticCells = 32;
// A key that differs from every valid key.
const std::vector<double> NoKey{ -1.0 };
// Maximum number of samples per area light. More would not be visible at the grid's resolution.
constexpr int MaximumLightSamples = 16;

// Returns the lights that the medium attenuates. Multiple scattering is computed only for them.
std::vector<LightSource> FindLights(const VolumeRenderState& frame)
{
  std::vector<LightSource> lights;
  for (const LightSource& light : frame.Image->Lights)
  {
    if (light.ShadowStrength > 0.0 && light.Diffuse != glm::dvec3(0.0))
    {
      lights.push_back(light);
    }
  }
  return lights;
}

void Add(std::vector<double>& key, const double* values, std::size_t count)
{
  key.insert(key.end(), values, values + count);
}

void AddLight(std::vector<double>& key, const LightSource& light)
{
  key.insert(key.end(),
    { light.IsPositional ? 1.0 : 0.0, light.ConeCosine, light.Exponent, light.ShadowStrength });
  for (const glm::dvec3& v : { light.Position, light.Direction, light.Diffuse, light.Attenuation,
         light.EmitterAxes[0], light.EmitterAxes[1] })
  {
    Add(key, glm::value_ptr(v), 3);
  }
  Add(key, glm::value_ptr(light.ScreenFromUnit), 16);
  key.push_back(light.Projective ? static_cast<double>(light.Projective->GetMTime()) : 0.0);
  key.push_back(light.Area ? static_cast<double>(light.Area->GetMTime()) : 0.0);
}

bool Scatters(const VolumeRenderState& frame)
{
  return frame.Scattering.Mode >= Settings::FORWARD_SCATTERING;
}

// Returns an object's address as a component of a key.
double GetAddress(const void* object)
{
  return static_cast<double>(reinterpret_cast<std::uintptr_t>(object));
}

void AddVolume(std::vector<double>& key, const ScatteringUpdater::Volume& volume)
{
  const VolumeRenderState& frame = *volume.State;
  key.insert(key.end(),
    { GetAddress(&frame), static_cast<double>(volume.Versions[0]),
      static_cast<double>(volume.Versions[1]), static_cast<double>(volume.GridSize),
      Scatters(frame) ? 1.0 : 0.0, frame.Space.Radius });
  Add(key, glm::value_ptr(frame.Space.UnitFromTexture), 16);
  Add(key, glm::value_ptr(frame.GradientSteps), 3);
  const std::vector<double> regions = frame.Region.Regions.GetKey();
  Add(key, regions.data(), regions.size());
  for (const auto& range : frame.Region.Box)
  {
    Add(key, range.data(), 2);
  }
  for (const auto& plane : frame.Region.ClippingPlanes)
  {
    Add(key, plane.data(), 4);
  }
}

// Returns all inputs of scattered light except the phase function.
std::vector<double> MakeKey(const VolumeRenderState& frame,
  const std::vector<ScatteringUpdater::Volume>& volumes, const std::vector<LightSource>& lights,
  const Settings& settings, int lightSamples)
{
  std::vector<double> key{ static_cast<double>(settings.ScatteringMode), settings.ForwardSpread,
    static_cast<double>(settings.BackwardLayers), static_cast<double>(lightSamples),
    static_cast<double>(SurfaceOcclusionGrid::GetTime(frame.Image->Scene)),
    static_cast<double>(volumes.size()) };
  for (const ScatteringUpdater::Volume& volume : volumes)
  {
    AddVolume(key, volume);
  }
  for (const LightSource& light : lights)
  {
    // VolumeResources finds the light of each scattered-light map by address.
    key.push_back(GetAddress(light.Light));
    AddLight(key, light);
  }
  return key;
}
}

Error ScatteringUpdater::MakePhaseFunction(const Settings& settings, SliceScattering& scattering)
{
  this->Phase.SetIsotropic();
  Error error;
  if (scattering.Kind == Settings::HENYEY_GREENSTEIN_PHASE)
  {
    error = this->Phase.SetHenyeyGreenstein(settings.Anisotropy);
  }
  else if (scattering.Kind == Settings::TABLE_PHASE)
  {
    std::vector<double> values(SliceScattering::PhaseColumns);
    settings.PhaseTable->GetTable(-1.0, 1.0, SliceScattering::PhaseColumns, values.data());
    error = this->Phase.SetTable(values);
  }
  scattering.Phases.clear();
  for (int i = 0;
       !error && scattering.Kind == Settings::TABLE_PHASE && i < SliceScattering::PhaseColumns; ++i)
  {
    const double cosine = 2.0 * i / (SliceScattering::PhaseColumns - 1) - 1.0;
    scattering.Phases.push_back(
      static_cast<float>(4.0 * vtkMath::Pi() * this->Phase.Value(cosine)));
  }
  scattering.MeanCosine = this->Phase.Moment(1);
  return error;
}

Error ScatteringUpdater::SetPhase(const Settings& settings, SliceScattering& scattering)
{
  const bool isOn = settings.ScatteringMode != Settings::NO_SCATTERING;
  // Without a table the phase function is isotropic.
  const bool isTable = settings.PhaseFunction == Settings::TABLE_PHASE;
  const int kind =
    !isOn || (isTable && !settings.PhaseTable) ? Settings::ISOTROPIC_PHASE : settings.PhaseFunction;
  const vtkMTimeType time = kind == Settings::TABLE_PHASE ? settings.PhaseTable->GetMTime() : 0;
  scattering.Mode = settings.ScatteringMode;
  scattering.Brightness = settings.ScatteringBrightness;
  if (this->Mode == scattering.Mode && this->Kind == kind &&
    this->Anisotropy == settings.Anisotropy && this->TableTime == time)
  {
    return {};
  }
  scattering.Kind = kind;
  scattering.Anisotropy = settings.Anisotropy;
  Error error = this->MakePhaseFunction(settings, scattering);
  ++this->Version;
  this->Key = NoKey;
  this->Mode = error ? Settings::NO_SCATTERING : scattering.Mode;
  this->Kind = kind;
  this->Anisotropy = settings.Anisotropy;
  this->TableTime = time;
  return error;
}

bool ScatteringUpdater::HasSamePhaseFunction(const ScatteringUpdater& other) const
{
  return this->Kind == other.Kind && this->TableTime == other.TableTime &&
    (this->Kind != Settings::HENYEY_GREENSTEIN_PHASE || this->Anisotropy == other.Anisotropy);
}

bool ScatteringUpdater::MakeGrid(const std::vector<Volume>& volumes)
{
  std::vector<double> key;
  for (const Volume& volume : volumes)
  {
    AddVolume(key, volume);
  }
  if (key != this->GridKey)
  {
    std::vector<ExtinctionGrid::Volume> media;
    for (const Volume& volume : volumes)
    {
      const VolumeRenderState& own = *volume.State;
      media.push_back({ own.Samples, own.Blocks, own.Material, own.Space, own.Region,
        own.GradientSteps, own.UnitDistances,
        volume.GridSize > 0 ? volume.GridSize : AutomaticCells, Scatters(own) });
    }
    this->HasGrid = this->Grid.Build(media);
    this->GridKey = key;
  }
  // MakeField marks the blocked cells again.
  this->Grid.GetMedium().Blocked.clear();
  return this->HasGrid;
}

Error ScatteringUpdater::MakeField(vtkOpenGLRenderWindow* window, VolumeRenderState& frame,
  const std::vector<Volume>& volumes, const Settings& settings, int lightSamples)
{
  SliceScattering& scattering = frame.Scattering;
  scattering.Texels.clear();
  scattering.ForwardLights.clear();
  scattering.HasFluence = false;
  this->Cells = 0;
  this->BlockedCells = 0;
  const std::vector<LightSource> lights = FindLights(frame);
  if (!Scatters(frame))
  {
    this->Grid = ExtinctionGrid();
    this->GridKey = NoKey;
    return {};
  }
  if (lights.empty() || !this->MakeGrid(volumes))
  {
    return {};
  }
  ExtinctionGrid& grid = this->Grid;
  grid.GetMedium().Phase = this->Phase;
  std::vector<ScatteringLight> direct;
  direct.reserve(lights.size());
  for (const LightSource& light : lights)
  {
    direct.push_back(GridLight::Make(grid, light, lightSamples));
  }
  if (SurfaceOcclusionGrid::GetTime(frame.Image->Scene) > 0)
  {
    std::vector<std::vector<glm::vec3>> transmitted;
    if (Error error = SurfaceOcclusionGrid::Make(
          window, *frame.Image->Scene, grid, frame.Space.GetWorldFromUnit(), lights, transmitted))
    {
      return error;
    }
    for (std::size_t i = 0; i < transmitted.size(); ++i)
    {
      for (std::size_t cell = 0; cell < transmitted[i].size(); ++cell)
      {
        direct[i].Direct[cell] *= transmitted[i][cell];
      }
    }
    // Block cells only now, so that they stop only scattered light: shadow maps resolve direct
    // light better than blocked cells do.
    SurfaceOcclusionGrid::Block(*frame.Image->Scene, frame.Space.GetWorldFromUnit(), grid);
  }
  ScatteringSettings solverSettings;
  solverSettings.AngleVariance = settings.ForwardSpread > 0.0 ? settings.ForwardSpread : -1.0;
  solverSettings.BackwardLayers = settings.BackwardLayers;
  const bool isFull = scattering.Mode == Settings::FULL_SCATTERING;
  ScatteredLight field;
  ScatteringReport solved;
  if (Error error = ScatteringSolver::Solve(grid.GetMedium(), direct,
        isFull ? ScatteringMode::Full : ScatteringMode::Forward, solverSettings, field, solved))
  {
    return error;
  }
  ScatteredLightMaps maps(grid, field);
  scattering.Texels = std::move(maps.Texels);
  scattering.Nodes = maps.Nodes;
  scattering.HasFluence = !field.Fluence.empty();
  scattering.NodeFromUnit = maps.NodeFromUnit;
  for (std::size_t i = 0; i < field.Forward.size(); ++i)
  {
    scattering.ForwardLights.push_back(lights[i].Light);
  }
  const std::vector<unsigned char>& blocked = grid.GetMedium().Blocked;
  this->Cells = static_cast<int>(grid.GetMedium().GetNumberOfCells());
  this->BlockedCells = static_cast<int>(std::count(blocked.begin(), blocked.end(), 1));
  return {};
}

Error ScatteringUpdater::Solve(vtkOpenGLRenderWindow* window, VolumeRenderState& frame,
  const std::vector<Volume>& volumes, const Settings& settings, int lightSamples,
  const ScatteringUpdater* other, const SliceScattering* known)
{
  const double start = vtkTimerLog::GetUniversalTime();
  const int samples = std::min(lightSamples, MaximumLightSamples);
  const bool isRequired = Scatters(frame);
  const std::vector<double> key = isRequired
    ? MakeKey(frame, volumes, FindLights(frame), settings, samples)
    : std::vector<double>();
  if (key == this->Key)
  {
    return {};
  }
  Error error;
  if (isRequired && other && other->Key == key && this->HasSamePhaseFunction(*other))
  {
    frame.Scattering = *known;
    frame.Scattering.Brightness = settings.ScatteringBrightness;
    this->Cells = other->Cells;
    this->BlockedCells = other->BlockedCells;
  }
  else
  {
    error = this->MakeField(window, frame, volumes, settings, samples);
  }
  ++this->Version;
  this->Key = error ? NoKey : key;
  this->Solves = isRequired ? this->Solves + (this->Cells > 0 ? 1 : 0) : 0;
  this->Seconds = isRequired ? vtkTimerLog::GetUniversalTime() - start : 0.0;
  return error;
}

void ScatteringUpdater::Fill(SliceReport& report) const
{
  report.ScatteringSolves = this->Solves;
  report.ScatteringSeconds = this->Seconds;
  report.ScatteringCells = this->Cells;
  report.ScatteringBlockedCells = this->BlockedCells;
}

}
