// SPDX-License-Identifier: BSD-3-Clause
#ifndef CellMedium_h
#define CellMedium_h

#include "Support/Transport/TransportMedium.h"

namespace reference
{

/**
 * @class   CellMedium
 * @brief   a medium of cells, in each of which it is the same everywhere
 */
class CellMedium : public TransportMedium
{
public:
  /// Values of \a counts cells of a size from \a lower on, x first. Only \a albedo may have one
  /// value for all. std::invalid_argument for other numbers of values.
  CellMedium(const glm::dvec3& lower, const glm::dvec3& size, const std::array<int, 3>& counts,
    std::vector<double> extinction, std::vector<glm::dvec3> albedo);

  double GetExtinction(const glm::dvec3& place) const override;
  glm::dvec3 GetAlbedo(const glm::dvec3& place) const override;

private:
  std::size_t GetCell(const glm::dvec3& place) const;

  glm::dvec3 Size;
  std::array<int, 3> Counts;
  std::vector<double> Extinction;
  std::vector<glm::dvec3> Albedo;
};

}

#endif
