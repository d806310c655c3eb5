// SPDX-License-Identifier: BSD-3-Clause
#include "View/TetrahedraDepth.h"

#include "vtkSceneDepth.h"

#include <algorithm>
#include <array>
#include <limits>

namespace interlume
{

void TetrahedraDepth::Read(
  vtkRenderer* renderer, const TetrahedraView& view, int stride, bool isCutByFarPlane)
{
  std::array<int, 2> size{ { 0, 0 } };
  this->Depths.clear();
  const std::array<double, 2>& depthOfBuffer = view.GetDepthOfBuffer();
  const auto nothing = isCutByFarPlane ? static_cast<float>(depthOfBuffer[0] + depthOfBuffer[1])
                                       : std::numeric_limits<float>::lowest();
  if (!vtkSceneDepth::Read(renderer, this->Buffer, size) ||
    std::all_of(
      this->Buffer.begin(), this->Buffer.end(), [](float value) { return value >= 1.0f; }))
  {
    this->Depths.assign(
      isCutByFarPlane ? static_cast<std::size_t>(view.GetWidth()) * view.GetHeight() : 0, nothing);
    return;
  }
  this->Depths.reserve(static_cast<std::size_t>(view.GetWidth()) * view.GetHeight());
  for (int y = 0; y < view.GetHeight(); ++y)
  {
    const int row = std::min(y * stride + stride / 2, size[1] - 1);
    for (int x = 0; x < view.GetWidth(); ++x)
    {
      const int column = std::min(x * stride + stride / 2, size[0] - 1);
      const double value = this->Buffer[static_cast<std::size_t>(row) * size[0] + column];
      this->Depths.push_back(
        value >= 1.0 ? nothing : static_cast<float>(depthOfBuffer[0] + depthOfBuffer[1] * value));
    }
  }
}

}
