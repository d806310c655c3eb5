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
 * @brief   the colours of an emitter with an image, at the middles of the cells of a grid
 *
 * The grid is one of the unit square, as fine as the image and of 128 to 512 columns and rows. It
 * is made once for an image and gives any number of samples.
 */
class EmitterGrid
{
public:
  /// \a image has no error.
  EmitterGrid(bool isRound, vtkImageData* image);

  bool IsBlack() const { return this->Mean == glm::dvec3(0.0); }
  /// Returns the mean colour over its largest channel, black of a black emitter.
  glm::dvec3 GetColor() const;

  /// Moves points that are spread evenly to where the emitter is bright; returns their colours,
  /// each over its own brightness. The emitter is not black.
  std::vector<glm::dvec3> Warp(std::vector<glm::dvec2>& points) const;

  /// Maps the unit square to the emitter, -1/2 to 1/2, and keeps areas: of a round one by the map
  /// of P. Shirley and K. Chiu (1997).
  static glm::dvec2 GetPlace(bool isRound, const glm::dvec2& point);

private:
  int Size = 0;
  glm::dvec3 Mean{ 0.0, 0.0, 0.0 };
  std::vector<glm::dvec3> Colors;
  /// The brightness of all rows up to each, and of all cells of a row up to each.
  std::vector<double> Rows;
  std::vector<std::vector<double>> Columns;
};

}

#endif
