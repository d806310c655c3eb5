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

/// Maximum and mean allowed difference of an image's channels.
struct ImageBound
{
  double Max;
  double Mean;
};

/// Draws a scene with the mapper and with the reference, and prints the difference. Expects a
/// difference within the bound and a frame that is not empty. Returns the mapper's frame.
RgbaImage ExpectReference(Check& check, const std::string& name, vtkShadowedSliceMapper* mapper,
  const ShadowScene& scene, const ImageBound& bound);
/// Calls ExpectReference() with a new mapper.
RgbaImage ExpectReference(
  Check& check, const std::string& name, const ShadowScene& scene, const ImageBound& bound);

/// Prints the difference of two images. Expects that it is within the bound.
void ExpectSimilar(Check& check, const std::string& name, const RgbaImage& found,
  const RgbaImage& expected, const ImageBound& bound);

}

#endif
