#ifndef vtkUnstructuredFlowWalker_h
#define vtkUnstructuredFlowWalker_h

#include "vtkBoundaryPatches.h"
#include "vtkIsoparametricFlowWalker.h"
#include "vtkUnstructuredFlowField.h"

/**
 * @class   vtkUnstructuredFlowWalker
 * @brief   the walker of unstructured grids: neighbours by the points that faces share
 *
 * The place on a face is carried over exactly, by the face's own coordinates. Domain faces are the
 * patches of the boundary.
 */
class vtkUnstructuredFlowWalker : public vtkIsoparametricFlowWalker<vtkUnstructuredFlowField>
{
public:
  using vtkIsoparametricFlowWalker::vtkIsoparametricFlowWalker;

  void Prefetch(int face, int round) const { this->Shared->Prefetch(this->Stand, face, round); }

  /// Patches that stay where they are; without them there are no domain faces.
  void SetPatches(const vtkBoundaryPatches* patches) { this->Patches = patches; }
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
  const vtkBoundaryPatches* Patches = nullptr;
};

#endif
