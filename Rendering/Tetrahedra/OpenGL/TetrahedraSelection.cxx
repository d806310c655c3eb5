// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/TetrahedraSelection.h"

#include "Offscreen/PropSelection.h"

#include "vtkHardwareSelector.h"

#include <algorithm>

namespace interlume
{

bool TetrahedraSelection::IsDrawn(vtkHardwareSelector* selector)
{
  const int pass = selector->GetCurrentPass();
  return pass != vtkHardwareSelector::POINT_ID_LOW24 &&
    pass != vtkHardwareSelector::POINT_ID_HIGH24;
}

std::vector<float> TetrahedraSelection::MakeImage(vtkHardwareSelector* selector,
  const TetrahedraView& view, const std::vector<vtkIdType>& cells, const std::vector<float>& depths)
{
  const int shift = selector->GetCurrentPass() == vtkHardwareSelector::CELL_ID_HIGH24 ? 24 : 0;
  float color[3];
  const bool isPropPass = PropSelection::FindColor(selector, color);
  const auto width = static_cast<std::size_t>(view.GetWidth());
  std::vector<float> image(4 * cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    float* pixel = &image[4 * i];
    if (isPropPass)
    {
      std::copy_n(color, 3, pixel);
    }
    else
    {
      const vtkIdType cell = std::max<vtkIdType>(cells[i] - 1, 0);
      vtkHardwareSelector::Convert((cell >> shift) & 0xffffff, pixel);
    }
    const double depth = view.GetBufferFromDepth(
      static_cast<double>(i % width) + 0.5, static_cast<double>(i / width) + 0.5, depths[i]);
    pixel[3] = cells[i] == 0 ? -1.0f : static_cast<float>(std::max(0.0, std::min(depth, 1.0)));
  }
  return image;
}

}
