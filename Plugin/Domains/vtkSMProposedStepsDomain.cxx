// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMProposedStepsDomain.h"

#include "vtkArraySelection.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMUncheckedPropertyHelper.h"
#include "vtkTimeStepsInformation.h"

#include <cmath>

vtkStandardNewMacro(vtkSMProposedStepsDomain);

vtkSMProposedStepsDomain::vtkSMProposedStepsDomain() = default;
vtkSMProposedStepsDomain::~vtkSMProposedStepsDomain() = default;

int vtkSMProposedStepsDomain::SetDefaultValues(vtkSMProperty* property, bool useUnchecked)
{
  const vtkArraySelection selection = vtkArraySelection::Find(this);
  vtkSMProperty* intervals = this->GetRequiredProperty("Intervals");
  vtkSMProperty* range = this->GetRequiredProperty("Range");
  vtkSMProperty* limit = this->GetRequiredProperty("Limit");
  if (!selection.IsComplete() || !intervals || !range || !limit ||
    selection.GetNumberOfTimeSteps() < 2 ||
    selection.GetSeriesSize() > vtkArraySelection::MaximumSeriesSize)
  {
    return 0;
  }
  vtkTimeStepsInformation::Request request;
  request.Port = static_cast<int>(selection.Port);
  request.Association = selection.Association;
  request.Array = selection.Name;
  request.Intervals = vtkSMUncheckedPropertyHelper(intervals).GetDoubleArray();
  vtkSMUncheckedPropertyHelper(range).Get(request.Range, 2);
  request.Limit = vtkSMUncheckedPropertyHelper(limit).GetAsDouble();
  vtkNew<vtkTimeStepsInformation> information;
  information->Initialize(request);
  selection.Producer->GatherInformation(information);
  vtkSMPropertyHelper strideHelper(property);
  strideHelper.SetUseUnchecked(useUnchecked);
  strideHelper.Set(information->GetStride());
  // A range that the user has set is not shortened.
  const bool isShortened = information->GetLastStep() != request.Range[1];
  const bool isTooLong = isShortened && !range->IsValueDefault();
  if (isShortened && !isTooLong)
  {
    vtkSMPropertyHelper rangeHelper(range);
    rangeHelper.SetUseUnchecked(useUnchecked);
    rangeHelper.Set(1, information->GetLastStep());
  }
  if (isTooLong)
  {
    vtkWarningMacro("Even with Time Step Stride "
      << information->GetStride() << ", the number of tetrahedra exceeds " << request.Limit
      << " (Size Warning Limit). Shorten Time Step Range.");
  }
  else if (isShortened || information->GetStride() > 1)
  {
    vtkWarningMacro("Not all " << selection.GetNumberOfTimeSteps()
                               << " time steps are selected, so that there are about "
                               << std::round(information->GetTetrahedra() / 1e5) / 10
                               << " million tetrahedra. Change Time Step Stride (now "
                               << information->GetStride()
                               << ") and Time Step Range to select others.");
  }
  return 1;
}

void vtkSMProposedStepsDomain::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
