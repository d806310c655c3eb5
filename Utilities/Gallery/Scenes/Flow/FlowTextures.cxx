// SPDX-License-Identifier: BSD-3-Clause
#include "Gallery/Scenes/Flow/FlowTextures.h"

#include "Gallery/Look.h"

#include "vtkImageData.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>

namespace gallery
{
namespace
{
/// Edge length of a texture, in texels.
constexpr int SIZE = 2048;

/// Width of a line as a fraction of the distance between lines.
constexpr double LINE_WIDTH = 0.12;

/// Returns 1 on a line at each integer and 0 between lines, antialiased over the width \a pixel.
double Line(double x, double pixel)
{
  const double distance = std::abs(x - std::round(x)) - 0.5 * LINE_WIDTH;
  return std::min(1.0, std::max(0.0, 0.5 - distance / pixel));
}

// Blends a color of the given opacity with an opaque color. The image may have no alpha component.
void SetPixel(vtkImageData* image, int x, int y, const vtkColor3d& below, double opacity,
  const vtkColor3d& above, double fraction)
{
  auto* pixel = static_cast<unsigned char*>(image->GetScalarPointer(x, y, 0));
  if (image->GetNumberOfScalarComponents() == 4)
  {
    pixel[3] = static_cast<unsigned char>(255.0 * (opacity + fraction * (1.0 - opacity)) + 0.5);
  }
  for (int c = 0; c < 3; ++c)
  {
    pixel[c] =
      static_cast<unsigned char>(255.0 * ((1.0 - fraction) * below[c] + fraction * above[c]) + 0.5);
  }
}

vtkSmartPointer<vtkTexture> MakeTexture(vtkImageData* image)
{
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  texture->InterpolateOn();
  texture->MipmapOn();
  texture->RepeatOn();
  return texture;
}
}

vtkSmartPointer<vtkTexture> MakeGridTexture(
  int cellsU, int cellsV, const vtkColor3d& area, const vtkColor3d& line, double opacity)
{
  vtkNew<vtkImageData> image;
  const int height = cellsV > 0 ? SIZE : 1;
  image->SetDimensions(SIZE, height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, opacity < 1.0 ? 4 : 3);
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < SIZE; ++x)
    {
      const double u = cellsU * (x + 0.5) / SIZE;
      const double v = cellsV * (y + 0.5) / SIZE;
      const double fraction = std::max(Line(u, static_cast<double>(cellsU) / SIZE),
        cellsV > 0 ? Line(v, static_cast<double>(cellsV) / SIZE) : 0.0);
      SetPixel(image, x, y, area, opacity, line, fraction);
    }
  }
  return MakeTexture(image);
}
}
