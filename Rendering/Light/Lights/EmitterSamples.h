// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_EmitterSamples_h
#define interlume_EmitterSamples_h

#include "Lights/LightSource.h"

#include <vector>

#include <glm/vec2.hpp>

namespace interlume
{

class EmitterGrid;

/**
 * @class   EmitterSamples
 * @brief   stratified samples of an area light's emitter
 *
 * The samples are a digital net of G. Larcher and F. Pillichshammer (2001). For N = 2^m samples, it
 * is a (0,m,2)-net in base 2: in each division of the emitter into N equal rectangles, from N
 * columns to N rows, each rectangle contains one sample. For other N, each column and each row
 * contains one sample. A round emitter uses the area-preserving map of P. Shirley and K. Chiu
 * (1997). A single sample is at the center.
 *
 * With an image, the density of samples is proportional to the sum of the three channels, so bright
 * regions get many samples and black regions none. Sampling is deterministic.
 */
class EmitterSamples
{
public:
  struct Sample
  {
    /// Position on the emitter, x right and y up, from -1/2 to 1/2 in units of its size.
    glm::dvec2 Position{ 0.0, 0.0 };
    /// Fraction of the light in red, green and blue. In each channel, the weights of all samples
    /// add up to exactly 1.
    glm::dvec3 Weight{ 1.0, 1.0, 1.0 };
  };

  /// Returns \a count samples, or one if \a count is below 1. \a grid is null for a uniform
  /// emitter.
  static std::vector<Sample> Make(bool isRound, const EmitterGrid* grid, int count);

  static std::vector<Sample> Make(const LightSource& light, int count);

  /// Returns a light without extent that represents a sample of an area light. The ambient, diffuse
  /// and specular colors of the lights for all samples add up to those of \a light.
  static LightSource MakeSource(const LightSource& light, const Sample& sample);

  /// Returns \a lights, with each of the area lights at \a indices replaced by \a count lights
  /// without extent.
  static std::vector<LightSource> Split(
    const std::vector<LightSource>& lights, const std::vector<int>& indices, int count);
};

}

#endif
