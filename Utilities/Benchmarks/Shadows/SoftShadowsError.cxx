// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Suites/BenchParts.h"

#include "Benchmarks/Measures/BenchTiming.h"
#include "Benchmarks/Shadows/ShadowsMethods.h"
#include "Benchmarks/Shadows/ShadowsScene.h"

#include "vtkAreaLight.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <string>

namespace shadows
{
namespace
{
const char* const Norm = "channel difference, mean";
const char* const Layers = "sample-layers";
const char* const Convolution = "accumulated-convolution";
const char* const BufferSuffix = ", buffer";
const char* const Hard = "hard";
const char* const Default = "default";
const char* const EqualTime = "equal-time";
/// Diameter of the light divided by the diagonal of the volume.
constexpr double LightSize = 1.0;
constexpr int Repeats = 3;
/// Maximum number of point lights in one image of the reference. Shaders contain a copy of the
/// light code for each light, and software OpenGL takes minutes to compile hundreds of copies.
constexpr std::size_t MaximumLightsPerImage = 16;

using Change = std::function<void(vtkShadowedSliceMapper*)>;

std::vector<Case> MakeSoftCases(const BenchOptions& options)
{
  const int points = options.Pick(64, 32, 12);
  const int step = options.Pick(4, 8, 16);
  std::vector<Case> cases =
    WithPixels({ MakeRings(points), MakeBonsai(step, step), MakeBox(points), MakeSmoke(points) },
      options.Pick(256, 64, 16));
  for (Case& one : cases)
  {
    one = MakeScatteringCase(one);
    one.Scene.Lights = MakeAreaLights(one.Scene, LightSize);
  }
  return cases;
}

Change WithSamples(int method, int samples)
{
  return [=](vtkShadowedSliceMapper* mapper)
  {
    mapper->SetSoftShadowMethod(method);
    mapper->SetNumberOfLightSamples(samples);
  };
}

Change WithBuffer(int method, int size)
{
  return [=](vtkShadowedSliceMapper* mapper)
  {
    mapper->SetSoftShadowMethod(method);
    mapper->SetLightBufferSize(size);
  };
}

Change WithSpacing(int method, double spacing)
{
  return [=](vtkShadowedSliceMapper* mapper)
  {
    mapper->SetSoftShadowMethod(method);
    mapper->SetSliceSpacing(spacing);
  };
}

/// Returns all settings to be measured. \a spacing is the default slice spacing.
std::vector<Setting> MakeSettings(reference::VolumeStage& stage,
  const reference::ShadowScene& scene, double spacing, const BenchOptions& options)
{
  using Mapper = vtkShadowedSliceMapper;
  std::vector<Setting> settings;
  const auto put = [&settings](const std::string& name, double parameter, MethodPointer drawn) {
    settings.push_back({ name, parameter, std::move(drawn) });
  };
  const auto add = [&](const std::string& name, double parameter, const Change& change)
  { put(name, parameter, MakeSliceMethod(stage, scene, change)); };
  for (const int samples : options.Pick<std::vector<int>>({ 4, 8, 16, 32, 64 }, { 4, 16 }, { 4 }))
  {
    add(Layers, samples, WithSamples(Mapper::SAMPLE_LAYERS, samples));
  }
  for (const double factor :
    options.Pick<std::vector<double>>({ 0.5, 1.0, 2.0, 4.0 }, { 1.0, 2.0 }, { 1.0, 2.0 }))
  {
    add(Convolution, factor, WithSpacing(Mapper::ACCUMULATED_CONVOLUTION, factor * spacing));
  }
  for (const int size :
    options.Pick<std::vector<int>>({ 64, 128, 192, 256 }, { 32, 64 }, { 16, 32 }))
  {
    add(std::string(Layers) + BufferSuffix, size, WithBuffer(Mapper::SAMPLE_LAYERS, size));
    add(std::string(Convolution) + BufferSuffix, size,
      WithBuffer(Mapper::ACCUMULATED_CONVOLUTION, size));
  }
  add(Default, 1.0, nullptr);
  reference::ShadowScene hard = scene;
  hard.Lights = MakeAreaLights(scene, 0.0);
  put(Hard, 1.0, MakeSliceMethod(stage, hard));
  return settings;
}

/// Returns point lights at the sample positions of the area light \a light, in groups. The mean of
/// the images of all groups is the image under all point lights.
std::vector<std::vector<vtkSmartPointer<vtkLight>>> MakeSampleLights(vtkLight* light, int count)
{
  auto* area = vtkAreaLight::SafeDownCast(light);
  const double* position = light->GetPosition();
  const double* focus = light->GetFocalPoint();
  std::vector<std::vector<vtkSmartPointer<vtkLight>>> groups;
  for (const vtkAreaLight::Sample& sample : area->GetSamples(count))
  {
    auto one = vtkSmartPointer<vtkLight>::New();
    one->DeepCopy(light);
    one->SetPosition(sample.Position[0], sample.Position[1], sample.Position[2]);
    one->SetFocalPoint(sample.Position[0] + focus[0] - position[0],
      sample.Position[1] + focus[1] - position[1], sample.Position[2] + focus[2] - position[2]);
    one->SetIntensity(light->GetIntensity() * sample.Weight[0]);
    if (groups.empty() || groups.back().size() == MaximumLightsPerImage)
    {
      groups.emplace_back();
    }
    groups.back().push_back(one);
  }
  for (const auto& group : groups)
  {
    for (const auto& one : group)
    {
      one->SetIntensity(one->GetIntensity() * static_cast<double>(groups.size()));
    }
  }
  return groups;
}

reference::RgbaImage MakeReference(reference::VolumeStage& stage,
  const reference::ShadowScene& scene, double spacing, const BenchOptions& options)
{
  const Change change = [&](vtkShadowedSliceMapper* mapper)
  {
    mapper->SetSliceSpacing(0.5 * spacing);
    mapper->SetLightBufferSize(options.Pick(256, 128, 64));
  };
  const auto groups = MakeSampleLights(scene.Lights.front().Get(), options.Pick(256, 32, 16));
  reference::RgbaImage mean(scene.Size[0], scene.Size[1]);
  for (const auto& group : groups)
  {
    reference::ShadowScene lit = scene;
    lit.Lights = group;
    const reference::RgbaImage image = MakeSliceMethod(stage, lit, change)->Capture();
    for (std::size_t i = 0; i < mean.Values.size(); ++i)
    {
      mean.Values[i] += image.Values[i] / static_cast<double>(groups.size());
    }
  }
  return mean;
}

const Setting& Find(const std::vector<Setting>& settings, const char* name)
{
  return *std::find_if(
    settings.begin(), settings.end(), [&](const Setting& one) { return one.Name == name; });
}

BenchRow MakeRow(const Setting& setting, const std::string& name, const BenchRows& rows)
{
  BenchRow row = rows.Make(name, setting.Name, setting.Parameter);
  row.Seconds = setting.Seconds;
  row.Counts["processor_seconds"] = setting.Seconds.Processor;
  row.SetError(Norm, setting.Error);
  AddReport(setting.Drawn->GetSliceMapper()->GetReport(), row);
  return row;
}

/// Returns the convolution setting with the smallest error among those that take at most \a seconds
/// of CPU time. If all take longer, returns the fastest.
const Setting& FindEqualTime(const std::vector<Setting>& settings, double seconds)
{
  const Setting* best = nullptr;
  for (const Setting& setting : settings)
  {
    if (setting.Name.compare(0, std::string(Convolution).size(), Convolution) != 0)
    {
      continue;
    }
    const double time = setting.Seconds.Processor;
    const bool isInTime = time <= seconds;
    const bool isBest = !best ||
      (best->Seconds.Processor > seconds ? time < best->Seconds.Processor
                                         : isInTime && setting.Error < best->Error);
    best = isBest ? &setting : best;
  }
  return *best;
}

void AddSceneRows(
  reference::VolumeStage& stage, const Case& what, const BenchOptions& options, BenchRows& rows)
{
  const MethodPointer plain = MakeSliceMethod(stage, what.Scene);
  plain->Capture();
  const double spacing = plain->GetSliceMapper()->GetReport()->GetNumber("SliceSpacing");
  std::vector<Setting> settings = MakeSettings(stage, what.Scene, spacing, options);
  MeasureFrames(settings, options.Threads, Repeats);
  const reference::RgbaImage expected = MakeReference(stage, what.Scene, spacing, options);
  for (Setting& setting : settings)
  {
    setting.Error = reference::CompareImages(setting.Drawn->Capture(), expected).Mean;
  }
  const Setting& byDefault = Find(settings, Default);
  const Setting& hard = Find(settings, Hard);
  for (const Setting& setting : settings)
  {
    BenchRow row = MakeRow(setting, what.Name, rows);
    if (&setting == &byDefault)
    {
      row.Baseline = Hard;
      row.BaselineSeconds = hard.Seconds;
      row.Counts["over_hard"] = byDefault.Seconds.Processor / hard.Seconds.Processor;
    }
    rows.Add(row);
  }
  const Setting& rival = FindEqualTime(settings, byDefault.Seconds.Processor);
  BenchRow row = MakeRow(byDefault, what.Name, rows);
  row.Method = EqualTime;
  row.Baseline = Convolution;
  row.BaselineSeconds = rival.Seconds;
  row.Counts["convolution_over_default"] =
    byDefault.Error > 0.0 ? rival.Error / byDefault.Error : rival.Error;
  rows.Add(row);
}

/**
 * Measures errors of images of an isotropically scattering medium under a round area light. The
 * reference is rendered by the same mapper with 256 point lights (32 in quick runs), one for each
 * light sample and at most sixteen per image. It has half the default slice spacing and a light
 * buffer of 256^2 texels (128^2 in quick runs). processor_seconds is the CPU time of all threads.
 * Methods:
 * - `sample-layers`: the parameter is the number of light samples;
 * - `sample-layers, buffer`: the parameter is the size of the light buffer. The number of light
 *   samples is the default;
 * - `accumulated-convolution`: the parameter is the slice spacing relative to the default;
 * - `accumulated-convolution, buffer`: the parameter is the size of the light buffer;
 * - `hard`: a light of size 0;
 * - `default`: all settings have their defaults. The baseline is `hard`, and over_hard is the ratio
 *   of CPU times.
 *
 * Rows of method `equal-time` have the error of the default settings. Their baseline is the
 * convolution setting with the smallest error in at most the CPU time of the default settings, or
 * the fastest convolution setting if all take longer. convolution_over_default is the error of the
 * baseline divided by the error of the default settings.
 */
void AddSoftShadowRows(const BenchOptions& options, BenchRows& rows)
{
  const std::vector<Case> cases = MakeSoftCases(options);
  reference::VolumeStage stage(cases.front().Scene.Size);
  for (const Case& what : cases)
  {
    AddSceneRows(stage, what, options, rows);
  }
}

std::vector<BenchClaim> CheckSoftShadowClaims(const std::vector<BenchRow>& rows)
{
  return { BenchClaim::AtLeast("at equal time at most half the error of the convolution", 2.0, rows,
             CountOf(EqualTime, "convolution_over_default")),
    BenchClaim::AtMost("the default at most 1.6 times the time of hard shadows", 1.6, rows,
      CountOf(Default, "over_hard")) };
}

std::vector<BenchPlot> MakeSoftShadowPlots(const std::vector<BenchRow>& rows)
{
  std::vector<BenchPlot> plots;
  for (const BenchRow& row : rows)
  {
    if (row.Method == EqualTime)
    {
      continue;
    }
    BenchPlot& plot = FindOrAdd(plots,
      BenchPlot::OfErrors("soft-shadows-" + row.Case.substr(0, row.Case.find('-')),
        row.Case + ": error against run time, one area light", "time of a frame (s)",
        std::string("error: ") + Norm, "Which method for soft shadows (" + row.Case + ")?",
        "Labels are light samples, slice spacings relative to the default, or columns of the light "
        "buffer. The reference is the mean image of many point lights."));
    plot.AddRow(row, row.Method.find(Convolution) == 0);
    plot.SetDefault(Default);
  }
  return plots;
}
}

BenchPart MakeSoftShadowPart()
{
  return { AddSoftShadowRows, MakeSoftShadowPlots, CheckSoftShadowClaims };
}
}
