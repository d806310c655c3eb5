// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMScalarVolumeRepresentationProxy.h"

#include "vtkEstimatedOpacity.h"
#include "vtkIdColors.h"
#include "vtkLegendDigits.h"

#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkPVDataSetAttributesInformation.h"
#include "vtkPVXMLElement.h"
#include "vtkSMArrayListDomain.h"
#include "vtkSMPVRepresentationProxy.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxyManager.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMTransferFunctionManager.h"
#include "vtkSMUndoStack.h"
#include "vtkSMUndoStackBuilder.h"
#include "vtkSMViewProxy.h"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <sstream>
#include <tuple>

vtkStandardNewMacro(vtkSMScalarVolumeRepresentationProxy);

namespace
{
/// Returns true while a state file is loaded, or during undo and redo. Properties that are being
/// restored must not be changed.
bool IsRestoring(vtkSMProxy* proxy)
{
  if (proxy->GetSessionProxyManager()->GetInLoadXMLState())
  {
    return true;
  }
  vtkSMUndoStackBuilder* builder = vtkSMProxyManager::GetProxyManager()->GetUndoStackBuilder();
  vtkSMUndoStack* stack = builder ? builder->GetUndoStack() : nullptr;
  return stack && (stack->GetInUndo() || stack->GetInRedo());
}

bool HasFunctions(vtkSMProxy* display)
{
  return vtkSMPropertyHelper(display, "LookupTable", true).GetAsProxy() &&
    vtkSMPropertyHelper(display, "ScalarOpacityFunction", true).GetAsProxy();
}

/// Rank of an array; lower is better. The elements are true if the array contains ids, has a single
/// value, is a cell array, or has several components, respectively.
using Rank = std::tuple<bool, bool, bool, bool>;

/// Returns true if the array contains ids of points or cells.
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

struct ColorArray
{
  std::string Name;
  /// vtkDataObject::POINT or CELL.
  int Association = 0;
};

/// Returns the best numeric point or cell array in the display's list of arrays. The name is empty
/// if there is none.
ColorArray ChooseColorArray(vtkSMPVRepresentationProxy* display)
{
  ColorArray found;
  vtkSMProperty* property = display->GetProperty("ColorArrayName");
  auto* arrays = property ? property->FindDomain<vtkSMArrayListDomain>() : nullptr;
  const vtkSMPropertyHelper input(display, "Input");
  auto* source = vtkSMSourceProxy::SafeDownCast(input.GetAsProxy());
  if (!arrays || !source)
  {
    return found;
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
    if (found.Name.empty() || rank < best)
    {
      best = rank;
      found.Name = arrays->GetString(i);
      found.Association = association;
    }
  }
  return found;
}
}

vtkSMScalarVolumeRepresentationProxy::vtkSMScalarVolumeRepresentationProxy() = default;

vtkSMScalarVolumeRepresentationProxy::~vtkSMScalarVolumeRepresentationProxy() = default;

void vtkSMScalarVolumeRepresentationProxy::FollowDisplay(vtkSMPVRepresentationProxy* display)
{
  this->Superclass::FollowDisplay(display);
  const bool isRestoring = IsRestoring(display);
  const bool wasShown = this->IsShown;
  this->IsShown = vtkSMPropertyHelper(display, "Representation").GetAsString() == this->GetType();
  this->FollowScalars(display, isRestoring);
  bool isColored = display->GetUsingScalarColoring();
  if (!this->IsShown && wasShown)
  {
    this->IsSolidByChoice = !isColored && !this->NeedsArray;
  }
  if (this->IsShown && !wasShown)
  {
    this->NeedsArray = !isRestoring && !this->IsSolidByChoice;
  }
  this->NeedsArray = this->NeedsArray && !isColored;
  if (this->IsShown && !isRestoring)
  {
    if (this->NeedsArray || (isColored && !HasFunctions(display)))
    {
      isColored = this->ColorDisplay(display);
      this->NeedsArray = !isColored;
    }
    if (isColored)
    {
      this->ColorCategories(display);
    }
  }
  if (this->IsShown && isColored)
  {
    this->EstimateOpacity(display, isRestoring);
    if (!isRestoring)
    {
      vtkLegendDigits::Apply(display, this->LegendFormat);
    }
  }
}

void vtkSMScalarVolumeRepresentationProxy::FollowScalars(
  vtkSMPVRepresentationProxy* display, bool isRestoring)
{
  const vtkSMPropertyHelper input(display, "Input");
  auto* source = vtkSMSourceProxy::SafeDownCast(input.GetAsProxy());
  vtkPVXMLElement* hints = source ? source->GetHints() : nullptr;
  vtkPVXMLElement* hint = hints ? hints->FindNestedElementByName("ColorBy") : nullptr;
  vtkSMProperty* property =
    hint ? source->GetProperty(hint->GetAttributeOrEmpty("property")) : nullptr;
  const char* selected =
    property ? vtkSMPropertyHelper(property).GetInputArrayNameToProcess() : nullptr;
  if (!selected || this->Scalars == selected ||
    !source->GetDataInformation(input.GetOutputPort())
       ->GetArrayInformation(selected, vtkDataObject::POINT))
  {
    return;
  }
  const std::string previous = this->Scalars;
  this->Scalars = selected;
  const vtkSMPropertyHelper colors(display, "ColorArrayName");
  if (previous.empty() || isRestoring || !display->GetUsingScalarColoring() ||
    colors.GetInputArrayAssociation() != vtkDataObject::POINT ||
    colors.GetInputArrayNameToProcess() != previous)
  {
    return;
  }
  vtkSMViewProxy* view = vtkSMViewProxy::FindView(display);
  const bool hasLegend = view && vtkSMPVRepresentationProxy::IsScalarBarVisible(display, view);
  if (display->SetScalarColoring(selected, vtkDataObject::POINT))
  {
    display->RescaleTransferFunctionToDataRange(true);
  }
  if (hasLegend)
  {
    vtkNew<vtkSMTransferFunctionManager> manager;
    manager->UpdateScalarBars(view, vtkSMTransferFunctionManager::HIDE_UNUSED_SCALAR_BARS);
    vtkSMPVRepresentationProxy::SetScalarBarVisibility(display, view, true);
  }
}

bool vtkSMScalarVolumeRepresentationProxy::ColorDisplay(vtkSMPVRepresentationProxy* display)
{
  std::string name;
  int association = 0;
  if (display->GetUsingScalarColoring())
  {
    const vtkSMPropertyHelper array(display, "ColorArrayName");
    name = array.GetInputArrayNameToProcess();
    association = array.GetInputArrayAssociation();
  }
  else
  {
    const ColorArray choice = ChooseColorArray(display);
    name = choice.Name;
    association = choice.Association;
  }
  if (name.empty() || !display->SetScalarColoring(name.c_str(), association))
  {
    return false;
  }
  if (display->GetArrayInformationForColorArray())
  {
    display->RescaleTransferFunctionToDataRange(true);
  }
  return true;
}

void vtkSMScalarVolumeRepresentationProxy::ColorCategories(vtkSMPVRepresentationProxy* display)
{
  const std::string name =
    vtkSMPropertyHelper(display, "ColorArrayName").GetInputArrayNameToProcess();
  vtkPVXMLElement* categories = this->GetHints()->FindNestedElementByName("Categories");
  std::istringstream names(categories ? categories->GetAttributeOrEmpty("arrays") : "");
  bool isCategory = false;
  for (std::string category; names >> category;)
  {
    isCategory = isCategory || category == name;
  }
  vtkPVArrayInformation* array = isCategory ? display->GetArrayInformationForColorArray() : nullptr;
  if (!array || !HasFunctions(display))
  {
    return;
  }
  const double* range = array->GetComponentFiniteRange(0);
  const int ids = range[0] <= range[1] ? static_cast<int>(std::clamp(range[1], 0.0, 1e6)) + 1 : 0;
  vtkSMProxy* colors = vtkSMPropertyHelper(display, "LookupTable").GetAsProxy();
  if (this->PreparedArray == name && this->PreparedColors == colors && ids <= this->PreparedIds)
  {
    return;
  }
  this->PreparedArray = name;
  this->PreparedColors = colors;
  this->PreparedIds = ids;
  vtkIdColors::Apply(
    colors, vtkSMPropertyHelper(display, "ScalarOpacityFunction").GetAsProxy(), ids);
}

void vtkSMScalarVolumeRepresentationProxy::EstimateOpacity(
  vtkSMPVRepresentationProxy* display, bool isRestoring)
{
  vtkSMProxy* opacities = vtkSMPropertyHelper(display, "ScalarOpacityFunction").GetAsProxy();
  if (!opacities || !this->GetHints()->FindNestedElementByName("EstimatedOpacity") ||
    this->PreparedOpacities.count(opacities->GetGlobalID()) > 0)
  {
    return;
  }
  if (isRestoring || vtkEstimatedOpacity::Apply(opacities, display))
  {
    this->PreparedOpacities.insert(opacities->GetGlobalID());
  }
}

void vtkSMScalarVolumeRepresentationProxy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "IsShown: " << this->IsShown << "\n";
  os << indent << "NeedsArray: " << this->NeedsArray << "\n";
  os << indent << "IsSolidByChoice: " << this->IsSolidByChoice << "\n";
  os << indent << "Scalars: " << this->Scalars << "\n";
}
