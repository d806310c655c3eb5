// SPDX-License-Identifier: BSD-3-Clause
// ComparePixels rejects a change of scale by 5 % and a shift by one pixel, which VTK's image
// difference accepts.

#include "Support/Arrays/ReferenceIndices.h"
#include "Support/Drawing/PixelDifference.h"

#include "vtkImageData.h"
#include "vtkImageDifference.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

namespace
{
/// Largest error with which VTK's image tests pass.
constexpr double VTK_THRESHOLD = 10.0;
constexpr int SIZE = 200;

/// Draws a shaded sphere on a gray background. Its radius is multiplied by \a scale, and its center
/// is \a shift pixels to the right of the image's center.
vtkSmartPointer<vtkImageData> DrawSphere(double scale, double shift)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(SIZE, SIZE, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  const double radius = 70.0 * scale;
  for (const auto& [y, x] : reference::AllIndices(SIZE, SIZE))
  {
    const double dx = x - 0.5 * SIZE - shift;
    const double dy = y - 0.5 * SIZE;
    const double rest = radius * radius - dx * dx - dy * dy;
    auto* pixel = static_cast<unsigned char*>(image->GetScalarPointer(x, y, 0));
    for (int channel = 0; channel < 3; ++channel)
    {
      const double light = std::sqrt(std::max(rest, 0.0)) / radius;
      pixel[channel] =
        static_cast<unsigned char>(rest > 0.0 ? 90.0 + 50.0 * light + 20.0 * channel : 160.0);
    }
  }
  return image;
}

bool PassesVtk(vtkImageData* image, vtkImageData* baseline)
{
  vtkNew<vtkImageDifference> difference;
  difference->SetInputData(image);
  difference->SetImageData(baseline);
  difference->Update();
  std::cout << "VTK's error: " << difference->GetThresholdedError() << "; ";
  return difference->GetThresholdedError() <= VTK_THRESHOLD;
}

bool PassesHere(vtkImageData* image, vtkImageData* baseline)
{
  const interlume::PixelBounds bounds;
  const interlume::PixelDifference difference =
    interlume::ComparePixels(image, baseline, bounds.Step);
  std::cout << difference << "\n";
  return interlume::IsWithin(difference, bounds);
}
}

int main()
{
  bool passed = true;
  const auto expect = [&passed](bool holds, const std::string& what)
  {
    if (!holds)
    {
      std::cerr << "expected: " << what << "\n";
      passed = false;
    }
  };

  vtkSmartPointer<vtkImageData> baseline = DrawSphere(1.0, 0.0);
  vtkSmartPointer<vtkImageData> same = DrawSphere(1.0, 0.0);
  vtkSmartPointer<vtkImageData> larger = DrawSphere(1.05, 0.0);
  vtkSmartPointer<vtkImageData> shifted = DrawSphere(1.0, 1.0);

  expect(PassesVtk(same, baseline), "VTK accepts an identical image");
  expect(PassesHere(same, baseline), "an identical image passes");
  expect(PassesVtk(larger, baseline), "VTK accepts an image that is larger by 5 %");
  expect(!PassesHere(larger, baseline), "an image that is larger by 5 % fails");
  expect(PassesVtk(shifted, baseline), "VTK accepts an image that is shifted by a pixel");
  expect(!PassesHere(shifted, baseline), "an image that is shifted by a pixel fails");

  // A few pixels may differ, since rounding can change pixels at silhouettes.
  vtkSmartPointer<vtkImageData> speckled = DrawSphere(1.0, 0.0);
  static_cast<unsigned char*>(speckled->GetScalarPointer(10, 10, 0))[0] = 0;
  expect(PassesHere(speckled, baseline), "a single changed pixel passes");

  vtkNew<vtkImageData> narrow;
  narrow->SetDimensions(SIZE - 1, SIZE, 1);
  narrow->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  expect(!PassesHere(narrow, baseline), "an image of another size fails");
  return passed ? EXIT_SUCCESS : EXIT_FAILURE;
}
