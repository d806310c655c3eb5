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
 * Text and legends, drawn into a renderer that covers the whole window. Positions are in its
 * pixels, from the lower left.
 */
namespace gallery
{
enum class Align
{
  Left,
  Centre
};

/**
 * One line of text; \a y is its middle.
 */
void AddText(vtkRenderer* overlay, const std::string& text, double x, double y, int fontSize,
  Align align = Align::Centre, bool bold = false);

/**
 * A horizontal bar of \a colours over [lower, upper] with a title above and five labels below, in
 * the units of the value. \a x is its middle, \a y the lower edge of the bar.
 */
void AddColourBar(vtkRenderer* overlay, const std::string& title, vtkScalarsToColors* colours,
  double lower, double upper, double x, double y, double width, int fontSize);

/// A colour and what it stands for.
using ColourEntry = std::pair<vtkColor3d, std::string>;

/**
 * A row of colour patches with their labels, centred at (x, y), with a title above unless empty.
 */
void AddColourKey(vtkRenderer* overlay, const std::string& title,
  const std::vector<ColourEntry>& entries, double x, double y, int fontSize);
}

#endif
