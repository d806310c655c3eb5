// SPDX-License-Identifier: BSD-3-Clause
#ifndef Legend_h
#define Legend_h

#include "vtkColor.h"

#include <string>
#include <utility>
#include <vector>

class vtkRenderer;
class vtkScalarsToColors;

/**
 * Functions that add text and legends to a renderer that covers the window. Positions are in pixels
 * from the lower left corner.
 */
namespace gallery
{
enum class Align
{
  Left,
  Center
};

/**
 * Adds one line of text. \a y is its vertical center. \a x is its left end or its center, depending
 * on \a align.
 */
void AddText(vtkRenderer* overlay, const std::string& text, double x, double y, int fontSize,
  Align align = Align::Center, bool bold = false);

/**
 * Adds a horizontal color bar of \a colors over [lower, upper], with a title above it and five
 * labels below it. \a x is the horizontal center of the bar, \a y its lower edge.
 */
void AddColorBar(vtkRenderer* overlay, const std::string& title, vtkScalarsToColors* colors,
  double lower, double upper, double x, double y, double width, int fontSize);

/// A color and its label.
using ColorEntry = std::pair<vtkColor3d, std::string>;

/**
 * Adds a row of color patches with labels, centered at (x, y), and a title above it unless \a title
 * is empty.
 */
void AddColorKey(vtkRenderer* overlay, const std::string& title,
  const std::vector<ColorEntry>& entries, double x, double y, int fontSize);
}

#endif
