// SPDX-License-Identifier: BSD-3-Clause
#ifndef PlotMarks_h
#define PlotMarks_h

#include "vtkSmartPointer.h"

#include <array>
#include <cstddef>

class vtkImageData;

/**
 * Marks of the points of plots, which can be told apart by their shapes alone: VTK has five of its
 * own.
 */

/// How many marks there are.
constexpr std::size_t NumberOfMarks = 13;

/**
 * A mark as a square picture of RGBA bytes, smooth at its edge and transparent around it: \a colour
 * where it is inked, white where it is hollow. \a mark is taken modulo NumberOfMarks.
 */
vtkSmartPointer<vtkImageData> MakeMark(
  std::size_t mark, const std::array<unsigned char, 3>& colour);

#endif
