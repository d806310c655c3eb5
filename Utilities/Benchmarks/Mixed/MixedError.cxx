// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Mixed/MixedParts.h"

#include "Benchmarks/Measures/PictureEdges.h"
#include "Benchmarks/Mixed/MixedCases.h"
#include "Benchmarks/Mixed/MixedDrawing.h"
#include "Support/Pictures/ReferenceMixedPicture.h"

namespace mixed
{
namespace
{
const char* const ScenePass = "scene-pass";
const char* const Edges = "edges";
const char* const FlatP95 = "flat_p95";
const char* const LargestEdge = "edge_texels_largest";
/// Pixels in a texel of the rows `edges`, and how far from an edge they look, in pixels.
constexpr double PixelsInTexel = 4.0;
constexpr int Reach = 10;
/// How much red changes over the picture's width where there is no edge.
constexpr double Flat = 2.0;
/// How wide the plane is that depth maps show, and pictures.
constexpr double PlaneWidth = 6.0;
constexpr double PictureWidth = 2.2;

BenchRow MakeErrorRow(const Drawing& drawing, const reference::PictureError& error,
  const std::string& name, const char* method, const BenchRows& rows)
{
  BenchRow row = rows.Make(name, method, drawing.GetReport()->DepthMapResolution);
  row.SetError("channel difference, mean", error.Mean);
  row.Set({ { "largest", error.Max }, { "pixels_before", drawing.GetReport()->PixelsBefore },
    { "pixels_within", drawing.GetReport()->PixelsWithin },
    { "pixels_behind", drawing.GetReport()->PixelsBehind } });
  return row;
}

/**
 * Pictures of boxes and slabs of smoke by vtkShadowedScenePass against the ray caster in double
 * precision. `scene-pass`: at its defaults; the count flat_p95 is the difference of red below which
 * 95 % of the pixels away from edges are. `edges`: with depth maps whose texels are four pixels
 * wide; edge_texels and edge_texels_largest are how far shadows' edges are from their places.
 */
void AddErrorRows(const BenchOptions& options, BenchRows& rows)
{
  const int pixels = options.Pick(256, 96, 48);
  const int coarse = static_cast<int>(PlaneWidth / PictureWidth * pixels / PixelsInTexel);
  for (const Case& what : MakeSlabs(pixels))
  {
    const reference::RgbaPicture expected =
      reference::MakeMixedPicture(what.Scene, options.Pick(2, 1, 1));
    Drawing fine(what.Scene, Method::ScenePass);
    const reference::RgbaPicture picture = fine.Capture();
    BenchRow row =
      MakeErrorRow(fine, reference::ComparePictures(picture, expected), what.Name, ScenePass, rows);
    row.Counts[FlatP95] = MeasureFlat(picture, expected, Flat / pixels);
    rows.Add(row);

    Drawing wide(what.Scene, Method::ScenePass, coarse);
    const reference::RgbaPicture blurred = wide.Capture();
    row = MakeErrorRow(wide, reference::ComparePictures(blurred, expected), what.Name, Edges, rows);
    const EdgeDistances edges = MeasureEdges(blurred, expected, Reach);
    row.Set({ { "edges", edges.Edges }, { "edge_texels", edges.Mean / PixelsInTexel },
      { LargestEdge, edges.Largest / PixelsInTexel } });
    rows.Add(row);
  }
}

std::vector<BenchClaim> CheckErrorClaims(const std::vector<BenchRow>& rows)
{
  return { BenchClaim::AtMost(
             "attenuation of the slab off by at most 0.002, 95 % of the pixels away from edges",
             0.002, rows, CountOf(ScenePass, FlatP95)),
    BenchClaim::AtMost(
      "edges of shadows within half a texel", 0.5, rows, CountOf(Edges, "edge_texels")) };
}

std::vector<BenchPlot> MakeErrorPlots(const std::vector<BenchRow>& rows)
{
  BenchPlot plot = BenchPlot::OfBars("mixed-error",
    "Box, plane and slab of smoke: difference from the ray caster", "channel difference, mean");
  plot.XLabel = "where the box is";
  for (const BenchRow& row : rows)
  {
    if (row.Method == ScenePass && row.Counts.contains(FlatP95))
    {
      plot.AddBar(row.Case, ScenePass, false, *row.Error);
    }
  }
  return { plot };
}
}

BenchPart MakeErrorPart()
{
  return { AddErrorRows, MakeErrorPlots, CheckErrorClaims };
}
}
