// SPDX-License-Identifier: BSD-3-Clause
#ifndef AnalyticCases_h
#define AnalyticCases_h

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

/**
 * A field in a cube, an interval of its values, and the volume of the interval region if it has a
 * closed form.
 */
struct AnalyticCase
{
  std::string Name;
  /// Definition of the field, for the report.
  std::string Formula;
  std::function<double(double x, double y, double z)> Field;
  /// The cube is [Low, High]^3.
  double Low;
  double High;
  double Lower;
  double Upper;
  std::optional<double> Volume;

  /// Returns the field sampled in double precision on points^3 points.
  vtkSmartPointer<vtkImageData> Sample(int points) const;
};

/**
 * Returns the cases `sphere`, `torus`, `product` (trilinear, so interpolation is exact) and
 * `gyroid`.
 */
std::vector<AnalyticCase> MakeAnalyticCases();

#endif
