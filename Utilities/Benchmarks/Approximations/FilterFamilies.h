// SPDX-License-Identifier: BSD-3-Clause
#ifndef FilterFamilies_h
#define FilterFamilies_h

#include "Benchmarks/Approximations/Approximation.h"

/**
 * Questions of the suite `filter-errors`: results of filters compared with formulas.
 */
namespace approximations
{
/// vtkIsotableContour, vtkFlyingEdges3D and vtkContour3DLinearGrid at several grid resolutions.
Family MakeContourFamily();

/// vtkTetrahedralMesher with several values of MaximumVolume and QualityBound, and vtkDelaunay3D.
/// Adds no rows if the mesher was not built.
Family MakeMesherFamily();

/// vtkFlowCriticalPoints and vtkVectorFieldTopology at several grid resolutions.
Family MakeCriticalPointFamily();
/// vtkVortexAxis at several grid resolutions.
Family MakeVortexAxisFamily();
/// vtkStreamSurfaceParameters with several values of Resolution.
Family MakeStreamSurfaceFamily();

/// vtkFlowLIC with several values of StepLength.
Family MakeLicStepFamily();
}

#endif
