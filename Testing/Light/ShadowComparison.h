// SPDX-License-Identifier: BSD-3-Clause
#ifndef ShadowComparison_h
#define ShadowComparison_h

#include "Support/Images/RgbaImage.h"
#include "Support/Checks/ReferenceCheck.h"

#include <string>

class vtkShadowedSliceMapper;

namespace reference
{

struct ShadowScene;

/// Largest allowed maximum and mean difference between the channels of two images.
struct ImageBound
{
  double Max;
  double Mean;
};

/// Draws a scene with the mapper and with the reference renderer, and prints the difference.
/// Expects that the difference is within the bound and that the frame is not empty. Returns the
/// mapper's frame.
RgbaImage ExpectSimilarToReference(Check& check, const std::string& name,
  vtkShadowedSliceMapper* mapper, const ShadowScene& scene, const ImageBound& bound);
/// Calls ExpectSimilarToReference() with a new mapper.
RgbaImage ExpectSimilarToReference(
  Check& check, const std::string& name, const ShadowScene& scene, const ImageBound& bound);

/// Prints the difference of two images. Expects that it is within the bound.
void ExpectSimilar(Check& check, const std::string& name, const RgbaImage& found,
  const RgbaImage& expected, const ImageBound& bound);

}

#endif
