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
/// Traces one streamline with interlume::Advection through unbounded space, a box, or a regular
/// grid.
interlume::AdvectionResult Advect(
  const SingleCellWalker& field, const interlume::AdvectionOptions& options, Position start);
interlume::AdvectionResult Advect(
  const BoxWalker& field, const interlume::AdvectionOptions& options, Position start);
///@}

/// Advection options that own their termination surfaces.
struct OwningAdvectionOptions : interlume::AdvectionOptions
{
  std::vector<vtkSmartPointer<FormulaSurface>> OwnedSurfaces;
};
/// Returns options for forward advection with a maximum error of 1e-6 and without termination
/// surfaces.
OwningAdvectionOptions ForwardOptions();
/// Returns ForwardOptions() with termination surfaces, which get the ids 10, 20, 30 and so on.
OwningAdvectionOptions ForwardOptions(const std::vector<vtkSmartPointer<FormulaSurface>>& surfaces);

/// Returns the number of all steps, accepted and rejected, nonstiff and stiff.
int NumberOfSteps(const interlume::AdvectionResult& result);
double Distance(const double a[3], const Position& b);
/// Returns text such as "reached surface 10 at (u, v), time t after n steps".
std::string Describe(const interlume::AdvectionResult& result);

}

#endif
