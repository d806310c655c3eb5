// SPDX-License-Identifier: BSD-3-Clause
// Draws a two-pixel image over a viewport: interpolated, from a part of the image only, and as
// color with transmittance.
#include "Support/Checks/LargestError.h"
#include "Support/Checks/ReferenceCheck.h"

#include "vtkCommand.h"
#include "vtkFloatArray.h"
#include "Offscreen/ImageQuad.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace
{

using namespace reference;

constexpr int WIDTH = 40;
constexpr int HEIGHT = 10;
// The render target has 8 bits per channel, and many graphics cards filter textures with 8 bits.
constexpr double TOLERANCE = 2.0 / 255.0;
constexpr std::array<double, 3> BACKGROUND{ { 0.2, 0.4, 0.6 } };
const std::vector<float> IMAGE{ 0.1f, 0.0f, 0.3f, 0.9f, 0.5f, 0.2f, 0.0f, 0.3f };

/// Draws the quad at the end of a renderer's frame.
class QuadCommand : public vtkCommand
{
public:
  static QuadCommand* New() { return new QuadCommand; }
  void Execute(vtkObject* renderer, unsigned long, void*) override
  {
    auto* window =
      vtkOpenGLRenderWindow::SafeDownCast(static_cast<vtkRenderer*>(renderer)->GetRenderWindow());
    this->Quad.Upload(window, 2, 1, IMAGE);
    this->Quad.Draw(window, this->Features, this->Fraction);
    this->Quad.ReleaseGraphicsResources(window);
  }
  std::string Features;
  interlume::ImageQuad::Fraction Fraction{ { 1.0, 1.0 } };

private:
  interlume::ImageQuad Quad;
};

// Returns the value of an image channel at \a x in [0, 1], interpolated between pixel centers.
double Sample(int channel, double x)
{
  const double weight = std::min(std::max((x - 0.25) / 0.5, 0.0), 1.0);
  return IMAGE[channel] * (1.0 - weight) + IMAGE[channel + 4] * weight;
}

void CheckImage(Check& check, const std::string& name, const std::string& features, double fraction,
  const std::function<double(double alpha)>& transmittance)
{
  vtkNew<QuadCommand> command;
  command->Features = features;
  command->Fraction = { { fraction, 1.0 } };
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(BACKGROUND.data());
  renderer->AddObserver(vtkCommand::EndEvent, command);
  vtkNew<vtkRenderWindow> window;
  window->OffScreenRenderingOn();
  window->SetMultiSamples(0);
  window->SetSize(WIDTH, HEIGHT);
  window->AddRenderer(renderer);
  window->Render();
  vtkNew<vtkFloatArray> pixels;
  window->GetRGBAPixelData(0, 0, WIDTH - 1, HEIGHT - 1, 0, pixels);
  double largest = 0.0;
  for (vtkIdType i = 0; i < pixels->GetNumberOfTuples(); ++i)
  {
    const double x = (static_cast<double>(i % WIDTH) + 0.5) / WIDTH * fraction;
    for (int channel = 0; channel < 3; ++channel)
    {
      const double expected =
        Sample(channel, x) + transmittance(Sample(3, x)) * BACKGROUND[channel];
      reference::KeepLargest(largest, std::abs(pixels->GetComponent(i, channel) - expected));
    }
  }
  check.Equal(pixels->GetNumberOfTuples(), WIDTH * HEIGHT, name + ", pixels");
  check.That(largest <= TOLERANCE, name + ", error " + std::to_string(largest));
}

}

int TestImageQuad(int, char*[])
{
  Check check;
  const auto ofOpacity = [](double alpha) { return 1.0 - alpha; };
  const auto all = [](double) { return 1.0; };
  CheckImage(check, "opacity", "", 1.0, ofOpacity);
  CheckImage(check, "share", "", 0.6, ofOpacity);
  CheckImage(check, "sum", "SUM", 1.0, all);
  return check.Result();
}
