// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_StructuredWalker_h
#define interlume_StructuredWalker_h

#include "Fields/IsoparametricWalker.h"
#include "Fields/StructuredFlowField.h"

namespace interlume
{

/**
 * @class   StructuredWalkerOf
 * @brief   walker for structured grids, which finds neighbors by index and across the cuts of O-
 * and C-grids
 *
 * \a FieldType is StructuredFlowField or a derived class.
 */
template <typename FieldType>
class StructuredWalkerOf : public IsoparametricWalker<FieldType>
{
public:
  using IsoparametricWalker<FieldType>::IsoparametricWalker;

  void Prefetch(int face, int round) const
  {
    if (round == 0)
    {
      this->Shared->Prefetch(this->Stand, face);
    }
  }
  int GetDomainFace(int face) const
  {
    return this->Shared->IsDomainFace(this->Stand, face) ? face : -1;
  }
  void GetDomainParameters(int face, const double p[3], double uv[2]) const
  {
    this->Shared->GetParameters(this->Stand, face, p, uv);
  }
};

using StructuredWalker = StructuredWalkerOf<StructuredFlowField>;

}

#endif
