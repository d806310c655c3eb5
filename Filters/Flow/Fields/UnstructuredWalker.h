// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_UnstructuredWalker_h
#define interlume_UnstructuredWalker_h

#include "Fields/BoundaryPatches.h"
#include "Fields/IsoparametricWalker.h"
#include "Fields/UnstructuredFlowField.h"

namespace interlume
{

/**
 * @class   UnstructuredWalkerOf
 * @brief   walker for unstructured grids, which finds neighbors by face links
 *
 * Streamlines cross a face without a search: face coordinates map their position to the neighbor.
 * The domain faces are the patches of the boundary.
 *
 * \a FieldType is UnstructuredFlowField or a derived class.
 */
template <typename FieldType>
class UnstructuredWalkerOf : public IsoparametricWalker<FieldType>
{
public:
  using IsoparametricWalker<FieldType>::IsoparametricWalker;

  void Prefetch(int face, int round) const { this->Shared->Prefetch(this->Stand, face, round); }

  /// Sets the patches, which must outlive this object. Without patches, there are no domain faces.
  void SetPatches(const BoundaryPatches* patches) { this->Patches = patches; }
  int GetDomainFace(int face) const
  {
    return this->Patches ? this->Patches->Find(8 * this->GetCell() + face) : -1;
  }
  void GetDomainParameters(int face, const double p[3], double uv[2]) const
  {
    double x[3];
    this->GetPosition(p, x);
    this->Patches->GetParameters(this->GetDomainFace(face), x, uv);
  }

private:
  const BoundaryPatches* Patches = nullptr;
};

using UnstructuredWalker = UnstructuredWalkerOf<UnstructuredFlowField>;

}

#endif
