// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIdColors.h"

#include "vtkEstimatedOpacity.h"
#include "vtkVolumeFunctions.h"

#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMTransferFunctionManager.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace
{
using Color = std::array<double, 3>;

/// The ten Tableau colors, ordered so that adjacent colors differ strongly.
const std::array<Color, 10> PALETTE{ { { { 0.306, 0.475, 0.655 } }, { { 0.949, 0.557, 0.169 } },
  { { 0.349, 0.631, 0.310 } }, { { 0.882, 0.341, 0.349 } }, { { 0.463, 0.718, 0.698 } },
  { { 0.929, 0.788, 0.282 } }, { { 0.690, 0.478, 0.631 } }, { { 0.612, 0.459, 0.373 } },
  { { 1.000, 0.616, 0.655 } }, { { 0.729, 0.690, 0.675 } } } };

constexpr int MAXIMUM_IDS = 100;
/// Width of the transition between the colors of two ids.
constexpr double TRANSITION_WIDTH = 1e-3;

/// Returns a color map with a band of constant color for each id, in the format of the property
/// RGBPoints.
std::vector<double> MakeBands(int count)
{
  std::vector<double> points;
  for (int id = 0; id < count; ++id)
  {
    const Color& color = PALETTE[static_cast<std::size_t>(id) % PALETTE.size()];
    for (const double end : { id - 0.5 + TRANSITION_WIDTH, id + 0.5 })
    {
      points.push_back(end);
      points.insert(points.end(), color.begin(), color.end());
    }
  }
  return points;
}

bool HaveSameColors(const std::vector<double>& points, const std::vector<double>& others)
{
  if (points.size() != others.size())
  {
    return false;
  }
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (i % 4 != 0 && std::abs(points[i] - others[i]) > 1e-6)
    {
      return false;
    }
  }
  return true;
}

/// Returns true if the colors are ParaView's default, or those of MakeBands for any number of ids.
bool AreDefaultColors(vtkSMProxy* colors, const std::vector<double>& points)
{
  vtkSMProxy* prototype = colors->GetSessionProxyManager()->GetPrototypeProxy(
    colors->GetXMLGroup(), colors->GetXMLName());
  if (prototype &&
    HaveSameColors(points, vtkSMPropertyHelper(prototype, "RGBPoints").GetDoubleArray()))
  {
    return true;
  }
  const auto ids = static_cast<int>(points.size() / 8);
  return ids <= MAXIMUM_IDS && HaveSameColors(points, MakeBands(ids));
}
}

void vtkIdColors::Apply(vtkSMProxy* colors, vtkSMProxy* opacities, int count)
{
  const std::vector<double> bands = MakeBands(std::clamp(count, 2, MAXIMUM_IDS));
  vtkSMPropertyHelper points(colors, "RGBPoints");
  const std::vector<double> oldPoints = points.GetDoubleArray();
  if (oldPoints.size() != bands.size() && AreDefaultColors(colors, oldPoints))
  {
    points.Set(bands.data(), static_cast<unsigned int>(bands.size()));
    vtkSMPropertyHelper(colors, "ColorSpace").Set("RGB");
    vtkSMPropertyHelper(colors, "AutomaticRescaleRangeMode")
      .Set(vtkSMTransferFunctionManager::NEVER);
    vtkSMPropertyHelper annotations(colors, "Annotations");
    annotations.SetNumberOfElements(0);
    for (int id = 0; id < std::min(count, MAXIMUM_IDS); ++id)
    {
      const auto row = static_cast<unsigned int>(2 * id);
      annotations.Set(row, std::to_string(id).c_str());
      annotations.Set(row + 1, std::to_string(id).c_str());
    }
    colors->UpdateVTKObjects();
  }
  if (vtkEstimatedOpacity::IsDefault(opacities))
  {
    vtkSMPropertyHelper ramp(opacities, "Points");
    std::vector<double> flat = ramp.GetDoubleArray();
    flat[1] = vtkVolumeFunctions::FLAT_OPACITY;
    flat[5] = vtkVolumeFunctions::FLAT_OPACITY;
    ramp.Set(flat.data(), static_cast<unsigned int>(flat.size()));
    opacities->UpdateVTKObjects();
  }
}
