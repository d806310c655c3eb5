// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLegendDigits.h"

#include "vtkSMPVRepresentationProxy.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMTransferFunctionProxy.h"
#include "vtkSMViewProxy.h"

#include <algorithm>
#include <cmath>
#include <regex>

int vtkLegendDigits::Find(const double range[2])
{
  const double largest = std::max(std::abs(range[0]), std::abs(range[1]));
  const double digits = std::ceil(std::log10(largest / (range[1] - range[0])) - 1e-9) + 2.0;
  return std::isfinite(digits) ? static_cast<int>(std::clamp(digits, 2.0, 15.0)) : 2;
}

void vtkLegendDigits::Apply(vtkSMPVRepresentationProxy* display, std::string& lastFormat)
{
  vtkSMProxy* colors = vtkSMPropertyHelper(display, "LookupTable").GetAsProxy();
  vtkSMViewProxy* view = vtkSMViewProxy::FindView(display);
  vtkSMProxy* legend =
    view ? vtkSMTransferFunctionProxy::FindScalarBarRepresentation(colors, view) : nullptr;
  vtkSMProperty* property = legend ? legend->GetProperty("RangeLabelFormat") : nullptr;
  double range[2];
  if (!property || !vtkSMTransferFunctionProxy::GetRange(colors, range))
  {
    return;
  }
  vtkSMPropertyHelper helper(property);
  const std::string format = helper.GetAsString();
  if (format != lastFormat && !property->IsValueDefault())
  {
    return;
  }
  // The precision of e and E excludes the digit before the point. The format is that of printf, or
  // that of std::format since ParaView 6.
  static const std::regex precision("\\.[0-9]+([eE])");
  const std::string digits = "." + std::to_string(Find(range) - 1) + "$1";
  const std::string needed = std::regex_replace(format, precision, digits);
  if (needed != format)
  {
    helper.Set(needed.c_str());
    legend->UpdateVTKObjects();
  }
  lastFormat = needed;
}
