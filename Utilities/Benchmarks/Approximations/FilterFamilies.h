// SPDX-License-Identifier: BSD-3-Clause
#ifndef FilterFamilies_h
#define FilterFamilies_h

#include "Benchmarks/Approximations/Approximation.h"

/**
 * Families of the suite `filter-errors`, which compares results of filters with formulas.
 */
namespace approximations
{
/// Compares vtkIsotableContour, vtkFlyingEdges3D and vtkContour3DLinearGrid at several grid
/// resolutions.
Family MakeContourFamily();

/// Compares vtkTetrahedralMesher, with several values of MaximumVolume and QualityBound, with
/// vtkDelaunay3D. Adds no rows if the mesher was not built.
Family MakeMesherFamily();

/// Compares vtkFlowCriticalPoints and vtkVectorFieldTopology at several grid resolutions.
Family MakeCriticalPointFamily();
/// Measures vtkVortexAxis at several grid resolutions.
Family MakeVortexAxisFamily();
/// Measures vtkStreamSurfaceParameters with several values of Resolution.
Family MakeStreamSurfaceFamily();

/// Measures vtkFlowLIC with several values of StepLength.
Family MakeLicStepFamily();
}

#endif
