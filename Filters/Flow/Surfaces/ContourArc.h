// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ContourArc_h
#define interlume_ContourArc_h

#include "Surfaces/ContourPlaces.h"
#include "Surfaces/LevelContours.h"

#include <array>
#include <vector>

#include <glm/vec3.hpp>

class vtkTerminationSurface;

namespace interlume
{

/**
 * @class   ContourArc
 * @brief   a contour on a termination surface, measured in world units from its start
 */
class ContourArc
{
public:
  ContourPlaces::Curve Curve;
  bool IsClosed = false;

  double GetLength() const { return this->Curve.Lengths.back(); }

  /**
   * Measures the arcs of a contour on a part of a surface: one, or more open ones where the surface
   * has no point with some of its parameters. They start as vtkStreamSurfaceParameters says.
   */
  static std::vector<ContourArc> Measure(LevelContours::Contour contour,
    const vtkTerminationSurface& surface, int part, const std::array<bool, 2>& isPeriodic,
    const std::vector<glm::dvec3>& startPoints);
};

}

#endif
