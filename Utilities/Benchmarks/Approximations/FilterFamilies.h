// SPDX-License-Identifier: BSD-3-Clause
#ifndef FilterFamilies_h
#define FilterFamilies_h

#include "Benchmarks/Approximations/Approximation.h"

/**
 * The questions of the suite `filter-errors`: results of filters against formulas.
 */
namespace approximations
{
/// vtkIsotableContour by points of the grid, beside vtkFlyingEdges3D and vtkContour3DLinearGrid.
Family MakeContourFamily();

/// vtkTetrahedralMesher by MaximumVolume and QualityBound, beside vtkDelaunay3D; no rows where it
/// was not built.
Family MakeMesherFamily();

/// vtkFlowCriticalPoints by points of the grid, beside vtkVectorFieldTopology.
Family MakeCriticalPointFamily();
/// vtkVortexAxis by points of the grid.
Family MakeVortexAxisFamily();
/// vtkStreamSurfaceParameters by Resolution.
Family MakeStreamSurfaceFamily();

/// vtkFlowLIC by StepLength.
Family MakeLicStepFamily();
}

#endif
