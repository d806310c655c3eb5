// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Mixed/MixedParts.h"

#include "Benchmarks/Mixed/MixedCases.h"
#include "Benchmarks/Mixed/MixedDrawing.h"
#include "Support/Pictures/PictureTurn.h"

#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkNew.h"

#include <cmath>

namespace mixed
{
namespace
{
const char* const Views = "views";
const char* const Lights = "lights";

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
  reference::PictureTurn turn;
  // Once around, the second frame comes again, so that each has both of its neighbours.
  const int frames = degrees == 360 ? degrees + 2 : degrees;
  for (int i = 0; i < frames; ++i)
  {
    turn.Add(Turn(what, drawing, isOfLight, i));
  }
  what.Scene.Lights.front().Light->SetPosition(what.LightPosition.data());

  const double mean = turn.GetMean();
  const reference::PictureTurn::Bend bend = turn.GetMeanBend();
  const reference::PictureTurn::Bend change = turn.GetChangeBend();
  BenchRow row = rows.Make(what.Name, isOfLight ? Lights : Views, degrees);
  row.SetError("mean of a picture from its neighbours', largest, share", bend.Largest / mean);
  row.Set(
    { { "worst_frame", bend.At }, { "p95", bend.P95 / mean }, { "change_largest", change.Largest },
      { "change_worst_frame", change.At }, { "change_p95", change.P95 } });
  rows.Add(row);
}

/**
 * Pictures by vtkShadowedScenePass from views a degree apart, and under lights a degree apart, over
 * as many degrees as the parameter says, 360 in full runs. `views` and `lights`: the error is the
 * largest distance of a picture's mean from the middle of its neighbours', over the mean of all;
 * worst_frame is its place, p95 below which 95 % are. change_* is the same of the largest change of
 * a pixel's red from one picture to the next, as it is.
 */
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
    "no view and no light stands out: means at most 1 % from the middle of their neighbours'", 0.01,
    rows,
    [](const BenchRow& row)
    {
      const bool isTurn = row.Method == Views || row.Method == Lights;
      return isTurn ? row.Error : std::optional<double>();
    }) };
}
}

BenchPart MakeTurnPart()
{
  return { AddTurnRows, nullptr, CheckTurnClaims };
}
}
