// SPDX-License-Identifier: BSD-3-Clause
#include "Light/ShadowComparison.h"

#include "Support/Images/ReferenceShadowImage.h"
#include "Support/Drawing/ShadowImage.h"

#include "vtkNew.h"
#include "vtkShadowedSliceMapper.h"

#include <iostream>

namespace reference
{

RgbaImage ExpectSimilarToReference(Check& check, const std::string& name,
  vtkShadowedSliceMapper* mapper, const ShadowScene& scene, const ImageBound& bound)
{
  // The mapper draws first, because rendering updates the positions of lights that follow the
  // camera.
  RgbaImage found = DrawByMapper(mapper, scene);
  const RgbaImage expected = MakeShadowImage(scene);
  check.That(LargestAlpha(expected) > 0.1, name + ": the image is not empty");
  ExpectSimilar(check, name, found, expected, bound);
  return found;
}

RgbaImage ExpectSimilarToReference(
  Check& check, const std::string& name, const ShadowScene& scene, const ImageBound& bound)
{
  vtkNew<vtkShadowedSliceMapper> mapper;
  return ExpectSimilarToReference(check, name, mapper, scene, bound);
}

void ExpectSimilar(Check& check, const std::string& name, const RgbaImage& found,
  const RgbaImage& expected, const ImageBound& bound)
{
  const ImageError error = CompareImages(found, expected);
  std::cout << name << ": " << error << std::endl;
  check.Near(error.Max, 0.0, bound.Max, name + ", largest error", 1.0);
  check.Near(error.Mean, 0.0, bound.Mean, name + ", mean error", 1.0);
}

}
