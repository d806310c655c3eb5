// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceAdvection_h
#define ReferenceAdvection_h

#include "Support/AnalyticFlows/ReferenceFlow.h"
#include "Support/Flow/ReferenceSurfaces.h"
#include "Support/Flow/ReferenceWalkers.h"

#include "Advection/AdvectionOptions.h"

#include <string>

namespace reference
{

///@{
/// One streamline by interlume::Advection. All of space, a box, or a lattice.
interlume::AdvectionResult Advect(
  const SpaceWalker& field, const interlume::AdvectionOptions& options, Place start);
interlume::AdvectionResult Advect(
  const LatticeWalker& field, const interlume::AdvectionOptions& options, Place start);
///@}

/// Options that keep their surfaces.
struct KeepingOptions : interlume::AdvectionOptions
{
  std::vector<vtkSmartPointer<FormulaSurface>> Kept;
};
/// Largest error 1e-6, forwards, to no surface.
KeepingOptions ForwardOptions();
/// With these surfaces too, ids 10, 20, ... in their order.
KeepingOptions ForwardOptions(const std::vector<vtkSmartPointer<FormulaSurface>>& surfaces);

/// Accepted and rejected ones, of either method.
int NumberOfSteps(const interlume::AdvectionResult& result);
double Distance(const double a[3], const Place& b);
/// "reached surface 10 at (u, v), time t after n steps".
std::string Describe(const interlume::AdvectionResult& result);

}

#endif
