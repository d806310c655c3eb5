// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Mixed/MixedTurns.h"

#include "Benchmarks/Mixed/MixedCases.h"
#include "Benchmarks/Mixed/MixedDrawing.h"
#include "Pictures/RgbaPicture.h"

#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>

namespace mixed
{
namespace
{
const char* const Views = "views";
const char* const Lights = "lights";

/// The largest distance of a number from the middle of those before and after.
struct Bend
{
  double Largest = 0.0;
  int At = 0;
  double P95 = 0.0;
};

Bend MeasureBend(const std::vector<double>& numbers)
{
  std::vector<double> bends;
  for (std::size_t i = 1; i + 1 < numbers.size(); ++i)
  {
    bends.push_back(std::abs(0.5 * (numbers[i - 1] + numbers[i + 1]) - numbers[i]));
  }
  Bend bend;
  if (bends.empty())
  {
    return bend;
  }
  const auto largest = std::max_element(bends.begin(), bends.end());
  bend.Largest = *largest;
  bend.At = static_cast<int>(largest - bends.begin()) + 1;
  std::sort(bends.begin(), bends.end());
  bend.P95 = bends[static_cast<std::size_t>(0.95 * (bends.size() - 1))];
  return bend;
}

double GetMean(const reference::RgbaPicture& picture)
{
  double sum = 0.0;
  for (std::size_t k = 0; k < picture.Values.size(); k += 4)
  {
    sum += picture.Values[k];
  }
  return 4.0 * sum / static_cast<double>(picture.Values.size());
}

/// The largest change of a pixel's red.
double GetChange(const reference::RgbaPicture& from, const reference::RgbaPicture& to)
{
  double largest = 0.0;
  for (std::size_t k = 0; k < from.Values.size(); k += 4)
  {
    largest = std::max(largest, std::abs(to.Values[k] - from.Values[k]));
  }
  return largest;
}

/// The picture from the view, or under light from the direction, of so many degrees.
reference::RgbaPicture Turn(const Case& what, Drawing& drawing, bool isOfLight, double degrees)
{
  if (isOfLight)
  {
    const double angle = vtkMath::RadiansFromDegrees(degrees);
    what.Scene.Lights.front().Light->SetPosition(-std::cos(angle), -std::sin(angle), 0.8);
  }
  else
  {
    vtkNew<vtkCamera> turned;
    turned->DeepCopy(what.Scene.Camera);
    turned->Azimuth(degrees);
    drawing.SetCamera(turned);
  }
  return drawing.Capture();
}

void AddTurn(const Case& what, bool isOfLight, int degrees, BenchRows& rows)
{
  Drawing drawing(what.Scene, Method::ScenePass);
  std::vector<double> means;
  std::vector<double> changes;
  reference::RgbaPicture before;
  // Once around, the second frame comes again, so that each has both of its neighbours.
  const int frames = degrees == 360 ? degrees + 2 : degrees;
  double sum = 0.0;
  for (int i = 0; i < frames; ++i)
  {
    reference::RgbaPicture picture = Turn(what, drawing, isOfLight, i);
    means.push_back(GetMean(picture));
    sum += means.back();
    if (i > 0)
    {
      changes.push_back(GetChange(before, picture));
    }
    before = std::move(picture);
  }
  what.Scene.Lights.front().Light->SetPosition(what.LightPosition.data());

  const double mean = sum / frames;
  const Bend bend = MeasureBend(means);
  const Bend change = MeasureBend(changes);
  BenchRow row = rows.Make(what.Name, isOfLight ? Lights : Views);
  row.Parameter = degrees;
  row.ErrorNorm = "mean of a picture from its neighbours', largest, share";
  row.Error = bend.Largest / mean;
  row.Counts["worst_frame"] = bend.At;
  row.Counts["p95"] = bend.P95 / mean;
  row.Counts["change_largest"] = change.Largest;
  row.Counts["change_worst_frame"] = change.At;
  row.Counts["change_p95"] = change.P95;
  rows.Add(row);
}
}

void AddTurnRows(const BenchOptions& options, BenchRows& rows)
{
  const int degrees = options.Pick(360, 36, 4);
  for (const Case& what : MakeTurned(options.Pick(64, 48, 24), options.Pick(32, 16, 8)))
  {
    AddTurn(what, false, degrees, rows);
    AddTurn(what, true, degrees, rows);
  }
}

std::vector<BenchClaim> CheckTurnClaims(const std::vector<BenchRow>& rows)
{
  return { BenchClaim::AtMost(
    "no view and no light stands out: means at most 1 % from the middle of "
    "their neighbours'",
    0.01, rows,
    [](const BenchRow& row)
    {
      const bool isTurn = row.Method == Views || row.Method == Lights;
      return isTurn ? row.Error : std::optional<double>();
    }) };
}
}
