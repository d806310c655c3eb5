#ifndef ReferenceAdvection_h
#define ReferenceAdvection_h

#include "Flows/ReferenceFlow.h"
#include "Reference/Flow/ReferenceSurfaces.h"
#include "Reference/Flow/ReferenceWalkers.h"

#include "vtkAdvectionOptions.h"

#include <string>

namespace reference
{

///@{
/// One streamline by vtkAdvection. All of space, a box, or a lattice.
vtkAdvectionResult Advect(
  const SpaceWalker& field, const vtkAdvectionOptions& options, Place start);
vtkAdvectionResult Advect(
  const LatticeWalker<>& field, const vtkAdvectionOptions& options, Place start);
vtkAdvectionResult Advect(
  const LatticeWalker<true>& field, const vtkAdvectionOptions& options, Place start);
///@}

/// Options that keep their surfaces.
struct KeepingOptions : vtkAdvectionOptions
{
  std::vector<vtkSmartPointer<FormulaSurface>> Kept;
};
/// Largest error 1e-6, forwards, to no surface.
KeepingOptions ForwardOptions();
/// With these surfaces too, ids 10, 20, ... in their order.
KeepingOptions ForwardOptions(const std::vector<vtkSmartPointer<FormulaSurface>>& surfaces);

/// Accepted and rejected ones, of either method.
int NumberOfSteps(const vtkAdvectionResult& result);
double Distance(const double a[3], const Place& b);
/// "reached surface 10 at (u, v), time t after n steps".
std::string Describe(const vtkAdvectionResult& result);

}

#endif
