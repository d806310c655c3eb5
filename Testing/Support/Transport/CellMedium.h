// SPDX-License-Identifier: BSD-3-Clause
#ifndef CellMedium_h
#define CellMedium_h

#include "Support/Transport/TransportMedium.h"

namespace reference
{

/**
 * @class   CellMedium
 * @brief   medium on a regular grid of homogeneous cells
 */
class CellMedium : public TransportMedium
{
public:
  /// Creates \a counts cells of the given size. The grid's lower corner is \a lower. Values are in
  /// cell order, with x varying fastest. \a albedo may have a single value for all cells. Throws
  /// std::invalid_argument for other numbers of values.
  CellMedium(const glm::dvec3& lower, const glm::dvec3& size, const std::array<int, 3>& counts,
    std::vector<double> extinction, std::vector<glm::dvec3> albedo);

  double GetExtinction(const glm::dvec3& position) const override;
  glm::dvec3 GetAlbedo(const glm::dvec3& position) const override;

private:
  std::size_t GetCell(const glm::dvec3& position) const;

  glm::dvec3 Size;
  std::array<int, 3> Counts;
  std::vector<double> Extinction;
  std::vector<glm::dvec3> Albedo;
};

}

#endif
