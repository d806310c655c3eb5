// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Report/PlotMarks.h"

#include "vtkImageData.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr int Pixels = 64;
/// Places along an edge of a pixel that are asked for ink.
constexpr int Places = 4;

/// How far a place is within a shape, negative outside; pictures end at -1 and 1.
using Shape = double (*)(double x, double y);

double Disc(double x, double y)
{
  return 0.66 - std::hypot(x, y);
}

double Square(double x, double y)
{
  return 0.72 - std::max(std::abs(x), std::abs(y));
}

double Diamond(double x, double y)
{
  return (0.98 - std::abs(x) - std::abs(y)) / std::sqrt(2.0);
}

/// With its corner at the top.
double Triangle(double x, double y)
{
  return std::min(y + 0.7, (0.9 - y - 1.75 * std::abs(x)) / std::hypot(1.0, 1.75));
}

double TriangleDown(double x, double y)
{
  return Triangle(x, -y);
}

double Plus(double x, double y)
{
  const double thin = std::min(std::abs(x), std::abs(y));
  const double far = std::max(std::abs(x), std::abs(y));
  return std::min(0.16 - thin, 0.98 - far);
}

double Cross(double x, double y)
{
  return Plus((x + y) / std::sqrt(2.0), (x - y) / std::sqrt(2.0));
}

double Star(double x, double y)
{
  return std::max(Plus(x, y), Cross(x, y));
}

struct Mark
{
  Shape Form;
  /// Whether only the rim is inked.
  bool IsHollow;
};

/// Those that are least alike first.
const Mark Marks[] = { { &Disc, false }, { &Square, true }, { &Cross, false }, { &Triangle, false },
  { &Diamond, true }, { &Plus, false }, { &Square, false }, { &Disc, true },
  { &TriangleDown, false }, { &Star, false }, { &Triangle, true }, { &Diamond, false },
  { &TriangleDown, true } };
static_assert(sizeof(Marks) / sizeof(Marks[0]) == NumberOfMarks, "all are counted");

/// How wide a rim is.
constexpr double Rim = 0.22;
}

vtkSmartPointer<vtkImageData> MakeMark(std::size_t mark, const std::array<unsigned char, 3>& colour)
{
  const Mark& what = Marks[mark % NumberOfMarks];
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(Pixels, Pixels, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  auto* pixel = static_cast<unsigned char*>(image->GetScalarPointer());
  const auto place = [](int i) { return 2.0 * (i + 0.5) / (Places * Pixels) - 1.0; };
  for (int j = 0; j < Pixels; ++j)
  {
    for (int i = 0; i < Pixels; ++i, pixel += 4)
    {
      int covered = 0;
      int inked = 0;
      for (int k = 0; k < Places * Places; ++k)
      {
        const double within =
          what.Form(place(Places * i + k % Places), place(Places * j + k / Places));
        covered += within > 0.0 ? 1 : 0;
        inked += within > 0.0 && (!what.IsHollow || within < Rim) ? 1 : 0;
      }
      const double ink = covered > 0 ? static_cast<double>(inked) / covered : 1.0;
      for (int c = 0; c < 3; ++c)
      {
        pixel[c] = static_cast<unsigned char>(std::lround(255.0 + ink * (colour[c] - 255.0)));
      }
      pixel[3] = static_cast<unsigned char>(std::lround(255.0 * covered / (Places * Places)));
    }
  }
  return image;
}
