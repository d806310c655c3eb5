// SPDX-License-Identifier: BSD-3-Clause
// Tests the animation of the scene inflow-post. In the left half, the dyed region grows with time.
// In the right half, periodic dye pulses return to their first state.

#include "Gallery/GalleryImage.h"
#include "Gallery/Scene.h"
#include "Gallery/Stage.h"

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>

namespace
{
constexpr int WIDTH = 240;
constexpr int HEIGHT = 150;

bool Expect(bool holds, const std::string& what)
{
  if (!holds)
  {
    std::cerr << "expected: " << what << "\n";
  }
  return holds;
}

/// Returns the number of pixels in the left or right half that differ by more than \a tolerance in
/// a channel.
int CountChanges(vtkImageData* one, vtkImageData* other, bool isRight, int tolerance)
{
  int changes = 0;
  for (int y = 0; y < HEIGHT; ++y)
  {
    for (int x = isRight ? WIDTH / 2 : 0; x < (isRight ? WIDTH : WIDTH / 2); ++x)
    {
      const auto* a = static_cast<const unsigned char*>(one->GetScalarPointer(x, y, 0));
      const auto* b = static_cast<const unsigned char*>(other->GetScalarPointer(x, y, 0));
      const bool isSame = std::equal(a, a + 3, b,
        [tolerance](int left, int right) { return std::abs(left - right) <= tolerance; });
      changes += isSame ? 0 : 1;
    }
  }
  return changes;
}

bool CheckFrames()
{
  const gallery::DisplayKeepAlive display;
  const gallery::ImageSize size = { WIDTH, HEIGHT };
  gallery::Stage stage(size);
  gallery::FindScene("inflow-post")->Build(stage);
  if (!Expect(stage.HasAnimation(), "the scene has an animation"))
  {
    return false;
  }
  const auto draw = [&stage, &size](double part) { return stage.RenderFrame(part, size); };
  const vtkSmartPointer<vtkImageData> begin = draw(0.0);
  const vtkSmartPointer<vtkImageData> quarter = draw(0.25);
  const vtkSmartPointer<vtkImageData> later = draw(0.35);
  const vtkSmartPointer<vtkImageData> end = draw(1.0);
  constexpr int visible = 12;
  const int early = CountChanges(begin, quarter, false, visible);
  const int grown = CountChanges(begin, end, false, visible);
  bool isGood = Expect(early > 200, std::to_string(early) + " pixels are dyed after a quarter");
  isGood = Expect(grown > 2 * early,
             std::to_string(grown) + " pixels are dyed at the end, more than twice as many") &&
    isGood;
  isGood = Expect(CountChanges(begin, later, true, visible) > 500, "the dye moves") && isGood;
  isGood =
    Expect(CountChanges(later, draw(0.35), true, 0) == 0, "a phase has the same image again") &&
    isGood;
  return Expect(stage.GetReport().Panels == 0, "frames of the animation do not count as panels") &&
    isGood;
}
}

int main()
{
  try
  {
    return CheckFrames() ? EXIT_SUCCESS : EXIT_FAILURE;
  }
  catch (const std::exception& error)
  {
    std::cerr << error.what() << "\n";
    return EXIT_FAILURE;
  }
}
