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
/// Distance between the lines of a streamline texture, and edge length of a grid texture, in
/// texels.
constexpr int LINE_PERIOD = 256;
constexpr int SIZE = 2048;

/// Width of a line as a fraction of the distance between lines.
constexpr double LINE_WIDTH = 0.12;

/// Returns 1 on a line at each integer and 0 between lines, antialiased over the width \a pixel.
double Line(double x, double pixel)
{
  const double distance = std::abs(x - std::round(x)) - 0.5 * LINE_WIDTH;
  return std::min(1.0, std::max(0.0, 0.5 - distance / pixel));
}

void SetPixel(vtkImageData* image, int x, int y, const vtkColor3d& below, const vtkColor3d& above,
  double fraction)
{
  auto* pixel = static_cast<unsigned char*>(image->GetScalarPointer(x, y, 0));
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
  int cellsU, int cellsV, const vtkColor3d& area, const vtkColor3d& line)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(SIZE, SIZE, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int y = 0; y < SIZE; ++y)
  {
    for (int x = 0; x < SIZE; ++x)
    {
      const double u = cellsU * (x + 0.5) / SIZE;
      const double v = cellsV * (y + 0.5) / SIZE;
      const double fraction = std::max(
        Line(u, static_cast<double>(cellsU) / SIZE), Line(v, static_cast<double>(cellsV) / SIZE));
      SetPixel(image, x, y, area, line, fraction);
    }
  }
  return MakeTexture(image);
}

vtkSmartPointer<vtkTexture> MakeStreamlineTexture(
  const std::vector<vtkColor3d>& colors, double opacity)
{
  const int rows = static_cast<int>(colors.size());
  vtkNew<vtkImageData> image;
  image->SetDimensions(LINE_PERIOD, rows, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  for (int y = 0; y < rows; ++y)
  {
    for (int x = 0; x < LINE_PERIOD; ++x)
    {
      const double fraction = Line((x + 0.5) / LINE_PERIOD, 1.0 / LINE_PERIOD);
      const vtkColor3d& color = colors[static_cast<std::size_t>(y)];
      SetPixel(image, x, y, color, TextColor(), fraction);
      static_cast<unsigned char*>(image->GetScalarPointer(x, y, 0))[3] =
        static_cast<unsigned char>(255.0 * (opacity + fraction * (1.0 - opacity)) + 0.5);
    }
  }
  return MakeTexture(image);
}
}
