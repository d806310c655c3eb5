// SPDX-License-Identifier: BSD-3-Clause
#include "Plan/SlabTriangles.h"

#include "vtkSMPTools.h"

#include <algorithm>

namespace interlume
{

void SlabTriangles::Join(const std::vector<std::vector<float>>& slabs)
{
  this->Starts.assign(1, 0);
  for (const std::vector<float>& slab : slabs)
  {
    this->Starts.push_back(this->Starts.back() + slab.size() / 3);
  }
  this->Vertices.resize(3 * this->Starts.back());
  vtkSMPTools::For(0, static_cast<vtkIdType>(slabs.size()),
    [&](vtkIdType first, vtkIdType end)
    {
      for (vtkIdType slab = first; slab < end; ++slab)
      {
        const auto index = static_cast<std::size_t>(slab);
        std::copy(slabs[index].begin(), slabs[index].end(),
          this->Vertices.begin() + static_cast<std::ptrdiff_t>(3 * this->Starts[index]));
      }
    });
}

}
