// SPDX-License-Identifier: BSD-3-Clause
#ifndef ShadowComparison_h
#define ShadowComparison_h

#include "Support/Pictures/RgbaPicture.h"
#include "Support/Checks/ReferenceCheck.h"

#include <string>

class vtkShadowedSliceMapper;

namespace reference
{

struct ShadowScene;

/// The largest and the mean difference of a picture's channels that passes.
struct PictureBound
{
  double Max;
  double Mean;
};

/// Draws by the mapper as it is set, and by the reference, prints how far they are apart, and
/// expects that to be within the bound and something to be seen. Returns the mapper's picture.
RgbaPicture ExpectReference(Check& check, const std::string& name, vtkShadowedSliceMapper* mapper,
  const ShadowScene& scene, const PictureBound& bound);
/// The same with a new mapper.
RgbaPicture ExpectReference(
  Check& check, const std::string& name, const ShadowScene& scene, const PictureBound& bound);

/// Prints and expects the difference of two pictures.
void ExpectAlike(Check& check, const std::string& name, const RgbaPicture& found,
  const RgbaPicture& expected, const PictureBound& bound);

}

#endif
