// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ContourArc_h
#define interlume_ContourArc_h

#include "Surfaces/ContourLocator.h"
#include "Surfaces/LevelContours.h"

#include <array>
#include <vector>

#include <glm/vec3.hpp>

class vtkTerminationSurface;

namespace interlume
{

/**
 * @class   ContourArc
 * @brief   contour on a termination surface, with arc lengths from its start in world units
 */
class ContourArc
{
public:
  ContourLocator::Curve Curve;
  bool IsClosed = false;

  double GetLength() const { return this->Curve.Lengths.back(); }

  /**
   * Measures a contour on a part of a surface. The result is one arc, or several open arcs if the
   * surface has no point for some of the parameters. vtkStreamSurfaceParameters documents how start
   * points are used.
   */
  static std::vector<ContourArc> Measure(LevelContours::Contour contour,
    const vtkTerminationSurface& surface, int part, const std::array<bool, 2>& isPeriodic,
    const std::vector<glm::dvec3>& startPoints);
};

}

#endif
