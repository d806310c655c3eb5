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
 * @brief   computes stratified samples of an area light's emitter
 *
 * The samples are a net of G. Larcher and F. Pillichshammer (2001), a (0,m,2)-net in base 2 where
 * their number is 2^m: each of the N columns, each of the N rows and each of the N rectangles
 * between, of equal area, has one of them. For other numbers columns and rows have one each. A
 * round emitter gets them by the map of P. Shirley and K. Chiu (1997), which keeps areas. One
 * sample is the centre.
 *
 * With an image a sample's chance to be at a place is the sum of the three channels there, so that
 * bright places get many samples and black ones none. The samples depend on nothing but what is
 * given here.
 */
class EmitterSamples
{
public:
  struct Sample
  {
    /// The place on the emitter, x right and y up, each -1/2 to 1/2 of its size.
    glm::dvec2 Place{ 0.0, 0.0 };
    /// The share of the light that this sample stands for, of red, green and blue. The shares of
    /// all samples, added in order, are exactly 1 in each channel.
    glm::dvec3 Weight{ 1.0, 1.0, 1.0 };
  };

  /// Computes \a count samples, 1 where \a count is less. \a grid is null for a uniform emitter.
  static std::vector<Sample> Make(bool isRound, const EmitterGrid* grid, int count);

  /// Computes the samples of an area light.
  static std::vector<Sample> Make(const LightSource& light, int count);

  /// Makes the light without extent that stands for a sample of an area light. The sources of all
  /// samples add up to the colours of \a light, the ambient one too.
  static LightSource MakeSource(const LightSource& light, const Sample& sample);

  /// Returns lights with those of these indices, area lights, as lights without extent: \a count
  /// each, in the place of the area light.
  static std::vector<LightSource> Split(
    const std::vector<LightSource>& lights, const std::vector<int>& indices, int count);
};

}

#endif
