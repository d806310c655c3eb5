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
 * A field in a cube, an interval of its values, and, where there is a closed form, the volume
 * between them.
 */
struct AnalyticCase
{
  std::string Name;
  /// How the field is defined, for the report.
  std::string Formula;
  std::function<double(double x, double y, double z)> Field;
  /// The cube is [Low, High]^3.
  double Low;
  double High;
  double Lower;
  double Upper;
  std::optional<double> Volume;

  /// The field sampled, in double, on points^3 points.
  vtkSmartPointer<vtkImageData> Sample(int points) const;
};

/**
 * `sphere`, `torus`, `product` (which is trilinear, so that sampling adds no error) and `gyroid`.
 */
std::vector<AnalyticCase> MakeAnalyticCases();

#endif
