// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/SpaceTime/VortexFractions.h"

#include "vtkAnalyticFieldSource.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <string>

namespace interval4d
{
VortexFractions::VortexFractions(int points)
{
  vtkNew<vtkAnalyticFieldSource> source;
  source->SetFieldToVortex();
  source->SetDimensions(points, points, points);
  source->SetTimeRange(0.0, 1.0);
  source->SetNumberOfTimeSteps(2);
  this->What.Name = "vortex, 2 x " + std::to_string(points) + "^3 points";
  this->What.Steps = vtkSmartPointer<StoredTimeSteps>::New();
  this->What.Steps->AddStepsFrom(source);
  // This bound exceeds all values of the field.
  this->What.Upper = 100.0;

  vtkDataArray* scalars =
    vtkImageData::SafeDownCast(this->What.Steps->GetStep(0))->GetPointData()->GetScalars();
  this->Values.resize(scalars->GetNumberOfTuples());
  for (std::size_t i = 0; i < this->Values.size(); ++i)
  {
    this->Values[i] = scalars->GetTuple1(static_cast<vtkIdType>(i));
  }
  std::sort(this->Values.rbegin(), this->Values.rend());
}

bool VortexFractions::SetFraction(double fraction)
{
  const auto inside = static_cast<std::size_t>(fraction * static_cast<double>(this->Values.size()));
  if (inside == 0)
  {
    return false;
  }
  this->What.Lower = this->Values[inside];
  return true;
}
}
