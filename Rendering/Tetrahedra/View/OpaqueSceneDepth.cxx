// SPDX-License-Identifier: BSD-3-Clause
#include "View/OpaqueSceneDepth.h"

#include "Offscreen/SceneDepth.h"

#include <algorithm>

namespace interlume
{

bool OpaqueSceneDepth::Read(vtkRenderer* renderer)
{
  const bool isDrawn = SceneDepth::Read(renderer, this->Buffer, this->Size) &&
    std::any_of(this->Buffer.begin(), this->Buffer.end(), [](float value) { return value < 1.0f; });
  if (!isDrawn)
  {
    this->Buffer.clear();
  }
  return isDrawn;
}

void OpaqueSceneDepth::SetBuffer(const std::vector<float>& depths, const std::array<int, 2>& size)
{
  this->Buffer = depths;
  this->Size = size;
}

void OpaqueSceneDepth::Resample(const TetrahedraView& view, int stride, bool isCutByFarPlane)
{
  this->Depths.clear();
  if (this->Buffer.empty() && !isCutByFarPlane)
  {
    return;
  }
  this->Depths.reserve(static_cast<std::size_t>(view.GetWidth()) * view.GetHeight());
  for (int y = 0; y < view.GetHeight(); ++y)
  {
    const int row = std::min(y * stride + stride / 2, this->Size[1] - 1);
    for (int x = 0; x < view.GetWidth(); ++x)
    {
      const int column = std::min(x * stride + stride / 2, this->Size[0] - 1);
      const double value = this->Buffer.empty()
        ? 1.0
        : this->Buffer[static_cast<std::size_t>(row) * this->Size[0] + column];
      this->Depths.push_back(value >= 1.0 && !isCutByFarPlane
          ? NONE
          : static_cast<float>(view.GetDepthFromBuffer(x + 0.5, y + 0.5, value)));
    }
  }
}

}
