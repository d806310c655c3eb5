// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FlowLICReport_h
#define interlume_FlowLICReport_h

#include "Common/ReportValue.h"

#include <string>
#include <vector>

namespace interlume
{

/**
 * @class   FlowLICReport
 * @brief   values that vtkFlowLIC reports; see vtkFlowLIC::GetReport
 */
struct FlowLICReport
{
  vtkIdType Points = 0;
  vtkIdType PointsOutside = 0;
  vtkIdType PointsAtRest = 0;
  vtkIdType PointsWithShortLines = 0;
  int Steps = 0;
  double StepLength = 0.0;
  double Length = 0.0;
  double NoiseScale = 0.0;
  vtkIdType FillValues = 0;
  vtkIdType NonFiniteVectors = 0;
  std::vector<std::string> ConvertedCellArrays;

  void CopyTo(vtkInterlumeReport* report) const
  {
    ReportValue::Set(report,
      { { "Points", this->Points }, { "PointsOutside", this->PointsOutside },
        { "PointsAtRest", this->PointsAtRest },
        { "PointsWithShortLines", this->PointsWithShortLines }, { "Steps", this->Steps },
        { "StepLength", this->StepLength }, { "Length", this->Length },
        { "NoiseScale", this->NoiseScale }, { "FillValues", this->FillValues },
        { "NonFiniteVectors", this->NonFiniteVectors },
        { "ConvertedCellArrays", this->ConvertedCellArrays } });
  }
};

}

#endif
