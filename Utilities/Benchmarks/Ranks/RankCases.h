// SPDX-License-Identifier: BSD-3-Clause
#ifndef RankCases_h
#define RankCases_h

#include "vtkSmartPointer.h"

class vtkImplicitFlowField;
class vtkIntervalVolume;

/**
 * What several processes execute, each its piece. Every process makes the same pipeline; a source
 * makes its piece alone.
 */
namespace ranks
{
/// The interval volume of a wave of \a periods along x, each of \a cells, and one along y and z:
/// the same work in every period.
vtkSmartPointer<vtkIntervalVolume> MakeVolume(int cells, int periods);

/// The ABC flow, which is periodic, for a time in which no streamline goes far: the same work in
/// every period, of \a points and \a samples along an axis.
vtkSmartPointer<vtkImplicitFlowField> MakeFlow(int points, int periods, int samples);
}

#endif
