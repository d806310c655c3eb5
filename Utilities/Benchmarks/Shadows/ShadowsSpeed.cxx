// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Suites/BenchParts.h"

#include "Benchmarks/Measures/BenchTiming.h"
#include "Benchmarks/Shadows/ShadowsMethods.h"
#include "Benchmarks/Shadows/ShadowsScene.h"

#include "vtkImageData.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

namespace shadows
{
namespace
{
const char* const On = "shadows";
const char* const Off = "shadows-off";
const char* const Unlit = "unlit";
const char* const NoLights = "no-lights";
const std::vector<int> NumbersOfLights = { 1, 2, 4 };

std::vector<Case> MakeSpeedCases(const BenchOptions& options)
{
  std::vector<Case> cases;
  if (options.Size == BenchOptions::FULL)
  {
    cases = { MakeBonsai(1, 2), MakeBonsai(1, 1), MakeSphere(128), MakeRings(128) };
  }
  else if (options.Size == BenchOptions::QUICK)
  {
    cases = { MakeBonsai(2, 4), MakeSphere(48), MakeRings(48) };
  }
  else
  {
    cases = { MakeBonsai(16, 32), MakeSphere(12), MakeRings(12) };
  }
  return WithPixels(std::move(cases), options.Pick(512, 192, 32));
}

/// Settings whose frames are measured alternately. Each has a unique combination of name and number
/// of lights.
using Turns = std::vector<Setting>;

reference::ShadowScene WithLights(
  const reference::ShadowScene& scene, const Lights& lights, bool hasShadows, bool isShaded)
{
  reference::ShadowScene made = scene;
  made.Lights = lights;
  made.Shadows = hasShadows;
  if (!isShaded)
  {
    made.Property = vtkSmartPointer<vtkVolumeProperty>::New();
    made.Property->DeepCopy(scene.Property);
    made.Property->ShadeOff();
  }
  return made;
}

Turns MakeTurns(reference::VolumeStage& stage, const reference::ShadowScene& scene)
{
  Turns turns;
  const auto add = [&](const char* name, int number, MethodPointer method)
  {
    if (method)
    {
      turns.push_back({ name, static_cast<double>(number), std::move(method) });
    }
  };
  for (const int number : NumbersOfLights)
  {
    const Lights lights = MakeLights(scene, number);
    add(Off, number, MakeSliceMethod(stage, WithLights(scene, lights, false, true)));
    add(On, number, MakeSliceMethod(stage, WithLights(scene, lights, true, true)));
  }
  add(NoLights, 0, MakeSliceMethod(stage, WithLights(scene, {}, true, false)));
  add(Unlit, 1, MakeSliceMethod(stage, WithLights(scene, scene.Lights, false, false)));
  add(GpuBaseline, 1, MakeRayCastMethod(stage, scene, 1.0));
  add(GpuShadowsBaseline, 1, MakeShadowRayMethod(stage, scene, 1.0));
  return turns;
}

const Setting* Find(const Turns& turns, const std::string& name, int number)
{
  const auto found = std::find_if(turns.begin(), turns.end(),
    [&](const Setting& turn) { return turn.Name == name && turn.Parameter == number; });
  return found == turns.end() ? nullptr : &*found;
}

/// Creates the rows of one case.
struct RowMaker
{
  const Case& What;
  const Turns& All;
  const std::string& Device;
  BenchRows& Rows;

  void Add(const Setting& turn, const Setting* baseline) const
  {
    if (!baseline)
    {
      return;
    }
    BenchRow row = this->Rows.Make(this->What.Name, turn.Name, static_cast<int>(turn.Parameter));
    row.SetTimes(turn.Seconds, baseline->Name, baseline->Seconds);
    AddReport(turn.Drawn->GetSliceMapper()->GetReport(), row);
    if (row.Baseline == Off)
    {
      row.Set({ { "over_off", turn.Seconds / baseline->Seconds },
        { "over_one_light", turn.Seconds / Find(this->All, On, 1)->Seconds } });
    }
    row.Set({ { "voxels", this->What.Scene.Image->GetNumberOfPoints() },
      { "pixels", this->What.Scene.Size[0] * this->What.Scene.Size[1] },
      { "device", this->Device } });
    this->Rows.Add(row);
  }
};

void AddRows(
  reference::VolumeStage& stage, const Case& what, const BenchOptions& options, BenchRows& rows)
{
  Turns turns = MakeTurns(stage, what.Scene);
  const std::string device = stage.GetDevice();
  MeasureFrames(turns, options.Threads, options.GetRepeats());
  const RowMaker maker{ what, turns, device, rows };
  for (const Setting& turn : turns)
  {
    if (turn.Name == On)
    {
      maker.Add(turn, Find(turns, Off, static_cast<int>(turn.Parameter)));
    }
  }
  maker.Add(*Find(turns, Unlit, 1), Find(turns, NoLights, 0));
  maker.Add(*Find(turns, Off, 1), Find(turns, GpuBaseline, 1));
  maker.Add(*Find(turns, On, 1), Find(turns, GpuShadowsBaseline, 1));
}

bool IsOfBonsai(const BenchRow& row)
{
  return row.Case.compare(0, 6, "bonsai") == 0;
}

/// Returns a function for BenchClaim. For rows of bonsai cases with \a lights lights, it returns
/// the time with shadows divided by the time without shadows.
std::function<std::optional<double>(const BenchRow&)> OverOff(int lights)
{
  return [lights](const BenchRow& row) -> std::optional<double>
  {
    const bool concerned =
      row.Method == On && row.Baseline == Off && row.Parameter == lights && IsOfBonsai(row);
    return concerned ? std::optional<double>(row.Counts["over_off"].get<double>()) : std::nullopt;
  };
}

/// Returns 1 plus the mean time that each light after the first adds, relative to the time with one
/// light.
std::optional<double> OverFurtherLight(const BenchRow& row)
{
  if (row.Method != On || row.Baseline != Off || !IsOfBonsai(row) || row.Parameter == 1)
  {
    return std::nullopt;
  }
  const double further = row.Parameter.get<double>() - 1.0;
  return 1.0 + (row.Counts["over_one_light"].get<double>() - 1.0) / further;
}

/**
 * Measures the time of one frame of each case. The parameter is the number of lights. Methods:
 * - `shadows`, with the baseline `shadows-off`, which has the same lights without shadows. over_off
 *   is the time divided by the baseline's time, and over_one_light is the time divided by the time
 *   with one light;
 * - `shadows` with one light, with the baseline `gpu-shadows`;
 * - `shadows-off` with one light, with the baseline `gpu`;
 * - `unlit`: one light, with Shade and shadows off. The baseline `no-lights` is the same volume in
 *   a scene without lights.
 */
void AddSpeedRows(const BenchOptions& options, BenchRows& rows)
{
  const std::vector<Case> cases = MakeSpeedCases(options);
  reference::VolumeStage stage(cases.front().Scene.Size);
  for (const Case& what : cases)
  {
    AddRows(stage, what, options, rows);
  }
}

std::vector<BenchClaim> CheckSpeedClaims(const std::vector<BenchRow>& rows)
{
  const auto overNoLights = [](const BenchRow& row) -> std::optional<double>
  {
    return row.Method == Unlit ? std::optional<double>(*row.Seconds / *row.BaselineSeconds)
                               : std::nullopt;
  };
  return {
    BenchClaim::AtMost(
      "bonsai: shadows of one light take at most 1.5 times", 1.5, rows, OverOff(1)),
    BenchClaim::AtMost(
      "bonsai: each further light takes at most 1.3 times", 1.3, rows, OverFurtherLight),
    BenchClaim::AtMost("no light with shadows: at most 1.05 times the time without lights", 1.05,
      rows, overNoLights),
  };
}
}

BenchPart MakeSpeedPart()
{
  return { AddSpeedRows, nullptr, CheckSpeedClaims };
}
}
