// SPDX-License-Identifier: BSD-3-Clause
#ifndef RankCases_h
#define RankCases_h

#include "vtkSmartPointer.h"

class vtkImplicitFlowField;
class vtkIntervalVolume;

/**
 * Pipelines that run in several processes. Each process creates the same pipeline and requests its
 * own piece. Sources create only the requested piece.
 */
namespace ranks
{
/// Returns the interval volume of a wave with \a periods periods along x and one period along y and
/// z. Each period has \a cells cells along each axis, and all periods require the same work.
vtkSmartPointer<vtkIntervalVolume> MakeVolume(int cells, int periods);

/// Returns the implicit flow of the ABC field, advected for a short time, with \a periods periods
/// along x and one period along y and z. Each period has \a points points and \a samples samples
/// along each axis, and all periods require the same work.
vtkSmartPointer<vtkImplicitFlowField> MakeFlow(int points, int periods, int samples);
}

#endif
