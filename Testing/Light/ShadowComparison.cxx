// SPDX-License-Identifier: BSD-3-Clause
#include "Light/ShadowComparison.h"

#include "Support/Pictures/ReferenceShadowPicture.h"
#include "Support/Drawing/ShadowPicture.h"

#include "vtkNew.h"
#include "vtkShadowedSliceMapper.h"

#include <iostream>

namespace reference
{

RgbaPicture ExpectReference(Check& check, const std::string& name, vtkShadowedSliceMapper* mapper,
  const ShadowScene& scene, const PictureBound& bound)
{
  // The mapper first: lights that follow the camera are placed by then.
  RgbaPicture found = DrawByMapper(mapper, scene);
  const RgbaPicture expected = MakeShadowPicture(scene);
  check.That(LargestAlpha(expected) > 0.1, name + ": something is seen");
  ExpectAlike(check, name, found, expected, bound);
  return found;
}

RgbaPicture ExpectReference(
  Check& check, const std::string& name, const ShadowScene& scene, const PictureBound& bound)
{
  vtkNew<vtkShadowedSliceMapper> mapper;
  return ExpectReference(check, name, mapper, scene, bound);
}

void ExpectAlike(Check& check, const std::string& name, const RgbaPicture& found,
  const RgbaPicture& expected, const PictureBound& bound)
{
  const PictureError error = ComparePictures(found, expected);
  std::cout << name << ": " << error << std::endl;
  check.Near(error.Max, 0.0, bound.Max, name + ", largest error", 1.0);
  check.Near(error.Mean, 0.0, bound.Mean, name + ", mean error", 1.0);
}

}
