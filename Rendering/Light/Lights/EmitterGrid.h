// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_EmitterGrid_h
#define interlume_EmitterGrid_h

#include "Common/Vectors.h"

#include <vector>

#include <glm/vec2.hpp>

class vtkImageData;

namespace interlume
{

/**
 * @class   EmitterGrid
 * @brief   colors of an emitter's image, sampled at the cell centers of a grid
 *
 * The grid covers the unit square. It is as fine as the image, with 128 to 512 columns and rows. It
 * is computed once per image and serves any number of samples.
 */
class EmitterGrid
{
public:
  /// Computes the grid. \a image must be valid.
  EmitterGrid(bool isRound, vtkImageData* image);

  bool IsBlack() const { return this->Mean == glm::dvec3(0.0); }
  /// Returns the mean color, scaled so that its largest channel is 1, or black for a black emitter.
  glm::dvec3 GetColor() const;

  /// Moves uniformly distributed points so that their density is proportional to the emitter's
  /// brightness. Returns the color at each point, divided by the brightness there. The emitter must
  /// not be black.
  std::vector<glm::dvec3> Warp(std::vector<glm::dvec2>& points) const;

  /// Maps a point of the unit square to emitter coordinates from -1/2 to 1/2. The map preserves
  /// ratios of areas. For a round emitter, it is the map of P. Shirley and K. Chiu (1997).
  static glm::dvec2 MapToEmitter(bool isRound, const glm::dvec2& point);

private:
  int Size = 0;
  glm::dvec3 Mean{ 0.0, 0.0, 0.0 };
  std::vector<glm::dvec3> Colors;
  /// Prefix sums of the brightness: over the rows, and over the cells of each row.
  std::vector<double> Rows;
  std::vector<std::vector<double>> Columns;
};

}

#endif
