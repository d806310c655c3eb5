// SPDX-License-Identifier: BSD-3-Clause
// A slide projected onto the wall of a hazy room.

#include "Gallery/Scenes/Light/LightScreens.h"
#include "Gallery/Scenes/Light/HazyRoom.h"
#include "Gallery/Scene.h"

#include "vtkNew.h"
#include "vtkStdString.h"
#include "vtkTextProperty.h"
#include "vtkTextRenderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace
{
/// Coverage of a rendered word, 0 to 1, as a function of position. Coordinates range from 0 to 1
/// along the width and height of the word.
class Word
{
public:
  explicit Word(const std::string& word)
  {
    vtkNew<vtkTextProperty> style;
    style->SetFontFamilyToArial();
    style->BoldOn();
    style->SetFontSize(120);
    style->SetColor(1.0, 1.0, 1.0);
    vtkTextRenderer::GetInstance()->RenderString(style, word, this->Image, this->Size.data(), 72);
  }
  double GetAspect() const { return static_cast<double>(this->Size[0]) / this->Size[1]; }
  double GetCoverage(double u, double v) const
  {
    const int i = static_cast<int>(std::floor(u * this->Size[0]));
    const int j = static_cast<int>(std::floor(v * this->Size[1]));
    if (i < 0 || i >= this->Size[0] || j < 0 || j >= this->Size[1])
    {
      return 0.0;
    }
    return static_cast<unsigned char*>(this->Image->GetScalarPointer(i, j, 0))[3] / 255.0;
  }

private:
  vtkNew<vtkImageData> Image;
  std::array<int, 2> Size{ { 0, 0 } };
};

/// Width of the slide divided by its height.
constexpr double ASPECT = 1.6;

/// Radius of the emblem divided by the height of the slide.
constexpr double RADIUS = 0.25;

vtkSmartPointer<vtkImageData> MakeSlide()
{
  const Word word("INTERLUME");
  const vtkColor3d ink(0.08, 0.16, 0.30);
  return gallery::MakePattern(1024, static_cast<int>(1024 / ASPECT),
    [&](double u, double v)
    {
      // Coordinates relative to the center of the slide, in units of its height.
      const double x = ASPECT * (u - 0.5);
      const double y = v - 0.5;
      constexpr double width = 1.2;
      const double height = width / word.GetAspect();
      const double fraction = word.GetCoverage(x / width + 0.5, (y - 0.29) / height + 0.5);
      const double radius = std::hypot(x, y + 0.12);
      // The paper is warm on the left and cool on the right.
      const vtkColor3d paper(1.0 - 0.65 * u, 0.80, 0.40 + 0.60 * u);
      vtkColor3d color = paper;
      if (radius < RADIUS)
      {
        // The emblem is a disk cut into slices.
        const double slice = std::fmod((y + 0.12 + RADIUS) / (2.0 * RADIUS) * 5.72, 1.0);
        color = slice < 0.72 ? vtkColor3d(0.90, 0.20, 0.10) : paper;
      }
      if (std::max(std::abs(x) / (0.5 * ASPECT - 0.04), std::abs(y) / 0.46) > 1.0)
      {
        color = ink;
      }
      for (int c = 0; c < 3; ++c)
      {
        color[c] += fraction * (ink[c] - color[c]);
      }
      return color;
    });
}

void Build(gallery::Stage& stage)
{
  constexpr double height = 0.86;
  vtkSmartPointer<vtkProjectiveLight> projector = gallery::MakeProjector(
    { -0.7, -2.8, 1.1 }, { 0.22, 1.0, 0.70 }, ASPECT * height, height, 2.7, MakeSlide());
  gallery::AddHazyRoom(
    stage, 0.0016, { projector, gallery::MakeFillLight({ 0.5, -1.0, 0.6 }, 0.55) });
}

const gallery::SceneRegistration registration(
  { "room-slide", "2.23", "A slide on the wall of a room",
    "A light with a colored image on its screen, a slide projector, shines into a room with thin "
    "smoke, a constructive volume. The robot and the rings block parts of the image, and the smoke "
    "in front of the wall shows the colors of the slide.",
    {}, &Build });
}
