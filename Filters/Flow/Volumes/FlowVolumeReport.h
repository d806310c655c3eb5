// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FlowVolumeReport_h
#define interlume_FlowVolumeReport_h

#include "Common/ReportValue.h"

namespace interlume
{

/**
 * @class   FlowVolumeReport
 * @brief   values that vtkFlowVolume reports
 */
struct FlowVolumeReport
{
  /// Number of input cells.
  vtkIdType Cells = 0;
  /// Numbers of cells that have a corner without a result, of cells whose corners reached different
  /// surfaces, and of cells on a seam where the mapping is discontinuous.
  vtkIdType CellsWithoutResult = 0;
  vtkIdType CellsBetweenSurfaces = 0;
  vtkIdType CellsOnSeams = 0;
  /// Number of cells in which time is discontinuous because they are crossed by the surface that
  /// their streamlines reach.
  vtkIdType CellsAcrossSurfaces = 0;
  /// Number of other cells in which time changes by more than MaximumTimeJump.
  vtkIdType CellsWithTimeJumps = 0;
  /// Number of cells that were cut at a surface and not skipped. They also count as
  /// CellsWithoutResult, CellsBetweenSurfaces or CellsAcrossSurfaces.
  vtkIdType CellsCut = 0;
  /// Number of cells whose parameters were unwrapped, and number of these cells whose corners
  /// cannot be unwrapped to within half a period, so that their parameters are incorrect.
  vtkIdType CellsAcrossSeams = 0;
  vtkIdType CellsAroundPoles = 0;
  /// Number of points added for cells across seams.
  vtkIdType PointsOnSeams = 0;
  /// Number of times that each step was executed: classification of all cells, extraction by
  /// Inflow, extraction by time, and cutting of stream surfaces by time. 0 if the step was not
  /// required or its result was reused.
  int Preparations = 0;
  int InflowPasses = 0;
  int TimePasses = 0;
  int SurfaceCuts = 0;
  /// Number of ports for which normals were computed.
  int NormalPasses = 0;

  void CopyTo(vtkInterlumeReport* report) const
  {
    ReportValue::Set(report,
      { { "Cells", this->Cells }, { "CellsWithoutResult", this->CellsWithoutResult },
        { "CellsBetweenSurfaces", this->CellsBetweenSurfaces },
        { "CellsOnSeams", this->CellsOnSeams },
        { "CellsAcrossSurfaces", this->CellsAcrossSurfaces },
        { "CellsWithTimeJumps", this->CellsWithTimeJumps }, { "CellsCut", this->CellsCut },
        { "CellsAcrossSeams", this->CellsAcrossSeams },
        { "CellsAroundPoles", this->CellsAroundPoles }, { "PointsOnSeams", this->PointsOnSeams },
        { "Preparations", this->Preparations }, { "InflowPasses", this->InflowPasses },
        { "TimePasses", this->TimePasses }, { "SurfaceCuts", this->SurfaceCuts },
        { "NormalPasses", this->NormalPasses } });
  }
};

}

#endif
