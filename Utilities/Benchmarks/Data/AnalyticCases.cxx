// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Data/AnalyticCases.h"

#include "vtkDoubleArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <cmath>

vtkSmartPointer<vtkImageData> AnalyticCase::Sample(int points) const
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(points, points, points);
  const double spacing = (this->High - this->Low) / (points - 1);
  image->SetSpacing(spacing, spacing, spacing);
  image->SetOrigin(this->Low, this->Low, this->Low);
  vtkNew<vtkDoubleArray> values;
  values->SetName("value");
  values->SetNumberOfValues(image->GetNumberOfPoints());
  double x[3];
  for (vtkIdType id = 0; id < image->GetNumberOfPoints(); ++id)
  {
    image->GetPoint(id, x);
    values->SetValue(id, this->Field(x[0], x[1], x[2]));
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

std::vector<AnalyticCase> MakeAnalyticCases()
{
  const double pi = vtkMath::Pi();
  std::vector<AnalyticCase> cases;
  cases.push_back({ "sphere", "distance from the origin",
    [](double x, double y, double z) { return std::sqrt(x * x + y * y + z * z); }, -1.0, 1.0, 0.43,
    0.77, 4.0 / 3.0 * pi * (std::pow(0.77, 3) - std::pow(0.43, 3)) });
  cases.push_back({ "torus", "distance from a circle of radius 0.6",
    [](double x, double y, double z) { return std::hypot(std::hypot(x, y) - 0.6, z); }, -1.0, 1.0,
    0.13, 0.29, 2.0 * pi * pi * 0.6 * (0.29 * 0.29 - 0.13 * 0.13) });
  // Volume of { xyz <= c } in the unit cube.
  auto below = [](double c)
  {
    const double logarithm = std::log(c);
    return c * (1.0 - logarithm + 0.5 * logarithm * logarithm);
  };
  cases.push_back(
    { "product", "x y z in the unit cube", [](double x, double y, double z) { return x * y * z; },
      0.0, 1.0, 0.03, 0.2, below(0.2) - below(0.03) });
  cases.push_back({ "gyroid", "sin x cos y + sin y cos z + sin z cos x, one and a half periods",
    [](double x, double y, double z)
    { return std::sin(x) * std::cos(y) + std::sin(y) * std::cos(z) + std::sin(z) * std::cos(x); },
    0.4, 0.4 + 3.0 * pi, -0.3, 0.6, std::nullopt });
  return cases;
}
