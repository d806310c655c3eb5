// SPDX-License-Identifier: BSD-3-Clause
#ifndef Turns_h
#define Turns_h

#include <functional>
#include <string>

namespace gallery
{
struct Scene;

/**
 * How far single frames stand out while a panel turns by a degree from frame to frame: second
 * differences, as reference::PictureTurn finds them, of the mean of red over that of all frames,
 * and of the largest change of a pixel's red, 0 to 1.
 */
struct Turn
{
  std::string Scene;
  /// The number of the panel, from 1.
  int Panel = 1;
  /// Whether the lights turn around the panel's middle and its vertical, or else the eye.
  bool IsOfLights = false;
  int Frames = 0;
  double Mean = 0.0;
  int MeanAt = 0;
  double MeanP95 = 0.0;
  int MeanOutliers = 0;
  double Change = 0.0;
  int ChangeAt = 0;
  double ChangeP95 = 0.0;
  int ChangeOutliers = 0;
};

/**
 * How a scene is turned: over so many degrees, in pictures of Width x Height pixels. Slices of
 * volumes are Coarseness times as far apart as in the first picture, and lights' buffers have as
 * many times fewer columns and rows: errors are larger then, and what stands out does so more.
 */
struct TurnSettings
{
  int Width = 64;
  int Height = 64;
  int Degrees = 360;
  double Coarseness = 1.0;
};

/**
 * Turns the eye, and then the lights that stand in the scene, of each panel, and visits each turn.
 */
void TurnScene(
  const Scene& scene, const TurnSettings& settings, const std::function<void(const Turn&)>& visit);

/// The heading of a table in Markdown, and the row of a turn.
std::string GetTurnsHeading();
std::string ToText(const Turn& turn);
}

#endif
