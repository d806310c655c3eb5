// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/Tetrahedra.h"

#include <algorithm>

namespace interlume
{

void Tetrahedra::RemoveUnusedPoints()
{
  constexpr vtkIdType unused = -1;
  std::vector<vtkIdType> newIds(this->Origins.size(), unused);
  for (vtkIdType point : this->Tetrahedra)
  {
    newIds[point] = 0;
  }
  vtkIdType kept = 0;
  for (std::size_t point = 0; point < newIds.size(); ++point)
  {
    if (newIds[point] != unused)
    {
      newIds[point] = kept;
      this->Origins[kept] = this->Origins[point];
      std::copy_n(&this->Points[3 * point], 3, &this->Points[3 * kept]);
      ++kept;
    }
  }
  this->Origins.resize(kept);
  this->Points.resize(3 * kept);
  for (vtkIdType& point : this->Tetrahedra)
  {
    point = newIds[point];
  }
}

}
