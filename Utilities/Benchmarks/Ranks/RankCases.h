// SPDX-License-Identifier: BSD-3-Clause
#ifndef RankCases_h
#define RankCases_h

#include "vtkSmartPointer.h"

class vtkImplicitFlowField;
class vtkIntervalVolume;

/**
 * Pipelines for several processes. Each process creates the same pipeline and requests its own
 * piece. Sources create only the requested piece.
 */
namespace ranks
{
/// Returns the interval volume of a wave with \a periods periods along x, of \a cells cells each,
/// and one period along y and z. All periods require the same work.
vtkSmartPointer<vtkIntervalVolume> MakeVolume(int cells, int periods);

/// Returns the implicit flow of the periodic ABC field, advected for a short time. Each period has
/// \a points points and \a samples samples along each axis; all periods require the same work.
vtkSmartPointer<vtkImplicitFlowField> MakeFlow(int points, int periods, int samples);
}

#endif
