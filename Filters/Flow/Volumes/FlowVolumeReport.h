// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FlowVolumeReport_h
#define interlume_FlowVolumeReport_h

#include "Common/ReportValue.h"

namespace interlume
{

/**
 * @class   FlowVolumeReport
 * @brief   holds the values of the report of vtkFlowVolume
 */
struct FlowVolumeReport
{
  /// The number of cells of the input.
  vtkIdType Cells = 0;
  /// The numbers of cells with a corner that has no result, with corners of different surfaces, and
  /// on a seam that the mapping does not continue over.
  vtkIdType CellsWithoutResult = 0;
  vtkIdType CellsBetweenSurfaces = 0;
  vtkIdType CellsOnSeams = 0;
  /// The numbers of cells across their own termination surface, where time jumps, and of other
  /// cells in which time jumps by more than MaximumTimeJump.
  vtkIdType CellsAcrossSurfaces = 0;
  vtkIdType CellsWithTimeJumps = 0;
  /// The number of cells without a result, between surfaces or across one that were cut at the
  /// surface that passes through them.
  vtkIdType CellsCut = 0;
  /// The numbers of cells whose parameters were unwrapped, and of those among them whose corners no
  /// unwrapping brings within half a period, so that parameters in them are wrong.
  vtkIdType CellsAcrossSeams = 0;
  vtkIdType CellsAroundPoles = 0;
  /// The number of points that were added for cells across seams.
  vtkIdType PointsOnSeams = 0;
  /// The numbers of times that all cells were looked at, that extractions were made by Inflow and
  /// by time, and that stream surfaces were cut by time. Each is 0 for what was not needed or was
  /// still there.
  int Preparations = 0;
  int InflowPasses = 0;
  int TimePasses = 0;
  int SurfaceCuts = 0;
  /// The number of ports that normals were computed for.
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
