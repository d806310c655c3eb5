// SPDX-License-Identifier: BSD-3-Clause
#ifndef Turns_h
#define Turns_h

#include <string>
#include <vector>

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
  double Change = 0.0;
  int ChangeAt = 0;
  double ChangeP95 = 0.0;
};

/**
 * Turns the eye, and then the lights that stand in the scene, of each panel over so many degrees,
 * in pictures of width x height pixels.
 */
std::vector<Turn> TurnScene(const Scene& scene, int width, int height, int degrees);

/// One line a turn, with a heading.
std::string ToText(const std::vector<Turn>& turns);
}

#endif
