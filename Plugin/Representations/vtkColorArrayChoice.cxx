// SPDX-License-Identifier: BSD-3-Clause
#include "vtkColorArrayChoice.h"

#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkPVDataSetAttributesInformation.h"
#include "vtkSMArrayListDomain.h"
#include "vtkSMPVRepresentationProxy.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSourceProxy.h"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <tuple>

namespace
{
/// The rank of an array, of which the smallest is best: no ids, with a range, of points, of one
/// component.
using Rank = std::tuple<bool, bool, bool, bool>;

/// Returns whether the array numbers the points or cells.
bool AreIds(vtkPVDataInformation* data, vtkPVArrayInformation* array, int association)
{
  vtkPVDataSetAttributesInformation* attributes = data->GetAttributeInformation(association);
  const int kinds[] = { vtkDataSetAttributes::GLOBALIDS, vtkDataSetAttributes::PEDIGREEIDS };
  return array->GetDataType() == VTK_ID_TYPE ||
    std::any_of(std::begin(kinds), std::end(kinds),
      [&](int kind)
      {
        vtkPVArrayInformation* ids = attributes->GetAttributeInformation(kind);
        return ids && ids->GetName() && array->GetName() &&
          std::strcmp(ids->GetName(), array->GetName()) == 0;
      });
}

Rank FindRank(vtkPVDataInformation* data, vtkPVArrayInformation* array, int association)
{
  const int components = array->GetNumberOfComponents();
  const double* range = array->GetComponentFiniteRange(components > 1 ? -1 : 0);
  return Rank(AreIds(data, array, association), !(range[0] < range[1]),
    association != vtkDataObject::POINT, components > 1);
}
}

vtkColorArrayChoice::vtkColorArrayChoice(vtkSMPVRepresentationProxy* display)
{
  vtkSMProperty* property = display->GetProperty("ColorArrayName");
  auto* arrays = property ? property->FindDomain<vtkSMArrayListDomain>() : nullptr;
  const vtkSMPropertyHelper input(display, "Input");
  auto* source = vtkSMSourceProxy::SafeDownCast(input.GetAsProxy());
  if (!arrays || !source)
  {
    return;
  }
  vtkPVDataInformation* data = source->GetDataInformation(input.GetOutputPort());
  Rank best;
  for (unsigned int i = 0; i < arrays->GetNumberOfStrings(); ++i)
  {
    const int association = arrays->GetFieldAssociation(i);
    if (association != vtkDataObject::POINT && association != vtkDataObject::CELL)
    {
      continue;
    }
    vtkPVArrayInformation* array = data->GetArrayInformation(arrays->GetString(i), association);
    if (!array || array->GetDataType() == VTK_STRING || array->GetNumberOfTuples() == 0)
    {
      continue;
    }
    const Rank rank = FindRank(data, array, association);
    if (!this->IsFound() || rank < best)
    {
      best = rank;
      this->Name = arrays->GetString(i);
      this->Association = association;
    }
  }
}
