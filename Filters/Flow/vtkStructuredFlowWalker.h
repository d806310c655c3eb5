#ifndef vtkStructuredFlowWalker_h
#define vtkStructuredFlowWalker_h

#include "vtkIsoparametricFlowWalker.h"
#include "vtkStructuredFlowField.h"

/**
 * @class   vtkStructuredFlowWalker
 * @brief   the walker of structured grids: neighbours by index, and over the cut of O- and C-grids
 */
class vtkStructuredFlowWalker : public vtkIsoparametricFlowWalker<vtkStructuredFlowField>
{
public:
  using vtkIsoparametricFlowWalker::vtkIsoparametricFlowWalker;

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

#endif
