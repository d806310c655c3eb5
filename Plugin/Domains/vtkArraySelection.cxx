// SPDX-License-Identifier: BSD-3-Clause
#include "vtkArraySelection.h"

#include "vtkPVDataInformation.h"
#include "vtkSMDomain.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMUncheckedPropertyHelper.h"

namespace
{
// Indices of the elements of an ArraySelection property that store the association and the name.
constexpr unsigned int AssociationElement = 3;
constexpr unsigned int NameElement = 4;
}

vtkArraySelection vtkArraySelection::Find(vtkSMDomain* domain)
{
  vtkArraySelection selection;
  vtkSMProperty* input = domain->GetRequiredProperty("Input");
  vtkSMProperty* array = domain->GetRequiredProperty("ArraySelection");
  if (input && array)
  {
    vtkSMUncheckedPropertyHelper inputHelper(input);
    vtkSMUncheckedPropertyHelper arrayHelper(array);
    if (inputHelper.GetNumberOfElements() > 0 && arrayHelper.GetNumberOfElements() > NameElement)
    {
      selection.Producer = vtkSMSourceProxy::SafeDownCast(inputHelper.GetAsProxy());
      selection.Port = inputHelper.GetOutputPort();
      selection.Association = arrayHelper.GetAsInt(AssociationElement);
      const char* name = arrayHelper.GetAsString(NameElement);
      selection.Name = name ? name : "";
    }
  }
  return selection;
}

int vtkArraySelection::GetNumberOfTimeSteps() const
{
  vtkPVDataInformation* information = this->Producer->GetDataInformation(this->Port);
  return information ? information->GetNumberOfTimeSteps() : 0;
}

double vtkArraySelection::GetSeriesSize() const
{
  vtkPVDataInformation* information = this->Producer->GetDataInformation(this->Port);
  return information
    ? static_cast<double>(information->GetNumberOfTimeSteps()) * information->GetMemorySize()
    : 0.0;
}
