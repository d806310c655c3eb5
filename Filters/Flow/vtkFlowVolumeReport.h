// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkFlowVolumeReport_h
#define vtkFlowVolumeReport_h

#include "InterlumeFlowModule.h" // for the export macro
#include "vtkIndent.h"
#include "vtkType.h"

#include <ostream>

/**
 * @class   vtkFlowVolumeReport
 * @brief   what an execution of vtkFlowVolume left out and why, and what it did
 *
 * @sa vtkFlowVolume
 */
struct INTERLUMEFLOW_EXPORT vtkFlowVolumeReport
{
  vtkIdType Cells = 0;
  /// Without an answer at a corner, with different ones, and on a seam that is not continued
  /// over.
  vtkIdType CellsWithoutAnswer = 0;
  vtkIdType CellsBetweenSurfaces = 0;
  vtkIdType CellsOnSeams = 0;
  /// Across their own termination surface, where time jumps, and of the others those where it
  /// jumps by more than MaximumTimeJump.
  vtkIdType CellsAcrossSurfaces = 0;
  vtkIdType CellsWithTimeJumps = 0;
  /// Of those without an answer, between surfaces and across one: cut at the surface that passes
  /// through them.
  vtkIdType CellsCut = 0;
  /// Unwrapped, and those of them whose corners no unwrapping brings within half a period:
  /// parameters in them are wrong.
  vtkIdType CellsAcrossSeams = 0;
  vtkIdType CellsAroundPoles = 0;
  /// Points added for cells across seams.
  vtkIdType PointsOnSeams = 0;
  /// How often all cells were looked at, extractions were made by Inflow and by time, and stream
  /// surfaces were cut by time: 0 for what was not needed, or was still there.
  int Preparations = 0;
  int InflowPasses = 0;
  int TimePasses = 0;
  int SurfaceCuts = 0;
  /// Ports that normals were computed of.
  int NormalPasses = 0;

  void Print(std::ostream& os, vtkIndent indent) const;
};

#endif
