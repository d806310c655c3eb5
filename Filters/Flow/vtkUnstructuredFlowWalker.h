#ifndef vtkUnstructuredFlowWalker_h
#define vtkUnstructuredFlowWalker_h

#include "vtkIsoparametricFlowWalker.h"
#include "vtkUnstructuredFlowField.h"

/**
 * @class   vtkUnstructuredFlowWalker
 * @brief   the walker of unstructured grids: neighbours by the points that faces share
 *
 * The place on a face is carried over exactly, by the face's own coordinates.
 */
class vtkUnstructuredFlowWalker : public vtkIsoparametricFlowWalker<vtkUnstructuredFlowField>
{
public:
  using vtkIsoparametricFlowWalker::vtkIsoparametricFlowWalker;

  void Prefetch(int face, int round) const { this->Shared->Prefetch(this->Stand, face, round); }
  int GetDomainFace(int) const { return -1; }
  void GetDomainParameters(int, const double*, double uv[2]) const { uv[0] = uv[1] = 0.0; }
};

#endif
