// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_EscapeRays_h
#define interlume_EscapeRays_h

#include "Scattering/MatterCells.h"

#include <vector>

#include <glm/vec3.hpp>

namespace interlume
{

/**
 * @class   EscapeRays
 * @brief   computes how much of what the cells send out leaves the medium
 *
 * It traces what an eye sees that looks at the box from everywhere: 192 directions, with a ray
 * through each cell of the sides that are seen, up to 8 along an edge. Fields are linear between
 * the middles of cells, and looked up where slices do.
 */
class EscapeRays
{
public:
  /**
   * What a cell scatters into direction w, for each unit of optical depth: its albedo times Fluence
   * times 1 + LeanFactor Lean . w, or, of a light that still goes in its direction, times the phase
   * function to w over that of an isotropic one.
   */
  struct Source
  {
    const std::vector<glm::vec3>* Fluence = nullptr;
    const std::vector<glm::vec3>* Lean = nullptr;
    double LeanFactor = 0.0;
    const ScatteringLight* Light = nullptr;
  };
  /// Sums over the box, for each color.
  struct Sums
  {
    /// What meets matter again.
    glm::dvec3 Kept{ 0.0 };
    /// What leaves the box against a direction, and with it.
    glm::dvec3 Back{ 0.0 };
    glm::dvec3 On{ 0.0 };
    /// What ends on blocked cells.
    glm::dvec3 Blocked{ 0.0 };

    glm::dvec3 GetOut() const { return this->Back + this->On + this->Blocked; }
    void Add(const Sums& other);
    void Scale(const glm::dvec3& factor);
    /// Scales all parts alike so that together they are what the cells send out.
    void ScaleTo(const glm::dvec3& sent);
    /// Scales by the matter that there is over what rays met, the more, the more of all light
    /// leaves: what leaves thick matter comes from its sides alone.
    void ScaleOut(double matter);
  };

  /// Traces several sources at once; what leaves against \a direction is kept apart.
  static std::vector<Sums> Trace(const MatterCells& matter, const PhaseFunction& phase,
    const std::vector<Source>& sources, const glm::dvec3& direction);
};

}

#endif
