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
  vtkIdType retained = 0;
  for (std::size_t point = 0; point < newIds.size(); ++point)
  {
    if (newIds[point] != unused)
    {
      newIds[point] = retained;
      this->Origins[retained] = this->Origins[point];
      std::copy_n(&this->Points[3 * point], 3, &this->Points[3 * retained]);
      ++retained;
    }
  }
  this->Origins.resize(retained);
  this->Points.resize(3 * retained);
  for (vtkIdType& point : this->Tetrahedra)
  {
    point = newIds[point];
  }
}

}
