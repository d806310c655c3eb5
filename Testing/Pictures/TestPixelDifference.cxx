// SPDX-License-Identifier: BSD-3-Clause
// The tight comparison of pictures, and what VTK's own lets through: a change of scale by 5 % and a
// shift by one pixel pass there and fail here.

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
/// Threshold at which VTK's tests pass.
constexpr double VTK_THRESHOLD = 10.0;
constexpr int SIZE = 200;

/// A shaded ball on grey paper, its radius scaled and its middle shifted to the right.
vtkSmartPointer<vtkImageData> DrawBall(double scale, double shift)
{
  auto picture = vtkSmartPointer<vtkImageData>::New();
  picture->SetDimensions(SIZE, SIZE, 1);
  picture->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  const double radius = 70.0 * scale;
  for (const auto& [y, x] : reference::AllIndices(SIZE, SIZE))
  {
    const double dx = x - 0.5 * SIZE - shift;
    const double dy = y - 0.5 * SIZE;
    const double rest = radius * radius - dx * dx - dy * dy;
    auto* pixel = static_cast<unsigned char*>(picture->GetScalarPointer(x, y, 0));
    for (int channel = 0; channel < 3; ++channel)
    {
      const double light = std::sqrt(std::max(rest, 0.0)) / radius;
      pixel[channel] =
        static_cast<unsigned char>(rest > 0.0 ? 90.0 + 50.0 * light + 20.0 * channel : 160.0);
    }
  }
  return picture;
}

bool PassesVtk(vtkImageData* picture, vtkImageData* baseline)
{
  vtkNew<vtkImageDifference> difference;
  difference->SetInputData(picture);
  difference->SetImageData(baseline);
  difference->Update();
  std::cout << "VTK's error " << difference->GetThresholdedError() << "; ";
  return difference->GetThresholdedError() <= VTK_THRESHOLD;
}

bool PassesHere(vtkImageData* picture, vtkImageData* baseline)
{
  const interlume::PixelBounds bounds;
  const interlume::PixelDifference difference =
    interlume::ComparePixels(picture, baseline, bounds.Step);
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

  vtkSmartPointer<vtkImageData> baseline = DrawBall(1.0, 0.0);
  vtkSmartPointer<vtkImageData> same = DrawBall(1.0, 0.0);
  vtkSmartPointer<vtkImageData> larger = DrawBall(1.05, 0.0);
  vtkSmartPointer<vtkImageData> shifted = DrawBall(1.0, 1.0);

  expect(PassesVtk(same, baseline), "VTK passes the same picture");
  expect(PassesHere(same, baseline), "the same picture passes");
  expect(PassesVtk(larger, baseline), "VTK passes a picture larger by 5 %");
  expect(!PassesHere(larger, baseline), "a picture larger by 5 % fails");
  expect(PassesVtk(shifted, baseline), "VTK passes a picture shifted by a pixel");
  expect(!PassesHere(shifted, baseline), "a picture shifted by a pixel fails");

  // One step everywhere is what rounding does, and a speck is what a silhouette does.
  vtkSmartPointer<vtkImageData> speckled = DrawBall(1.0, 0.0);
  static_cast<unsigned char*>(speckled->GetScalarPointer(10, 10, 0))[0] = 0;
  expect(PassesHere(speckled, baseline), "a single changed pixel passes");

  vtkNew<vtkImageData> narrow;
  narrow->SetDimensions(SIZE - 1, SIZE, 1);
  narrow->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  expect(!PassesHere(narrow, baseline), "a picture of another size fails");
  return passed ? EXIT_SUCCESS : EXIT_FAILURE;
}
