// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMScalarVolumeRepresentationProxy.h"

#include "vtkColorArrayChoice.h"
#include "vtkIdColors.h"

#include "vtkObjectFactory.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVXMLElement.h"
#include "vtkSMPVRepresentationProxy.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxyManager.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMUndoStack.h"
#include "vtkSMUndoStackBuilder.h"

#include <algorithm>
#include <sstream>

vtkStandardNewMacro(vtkSMScalarVolumeRepresentationProxy);

namespace
{
/// Returns whether a state file, or undo, sets the properties now, which then stay as they are set.
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
}

vtkSMScalarVolumeRepresentationProxy::vtkSMScalarVolumeRepresentationProxy() = default;

vtkSMScalarVolumeRepresentationProxy::~vtkSMScalarVolumeRepresentationProxy() = default;

void vtkSMScalarVolumeRepresentationProxy::FollowDisplay(vtkSMPVRepresentationProxy* display)
{
  this->Superclass::FollowDisplay(display);
  const bool isRestoring = IsRestoring(display);
  const bool wasShown = this->IsShown;
  this->IsShown = vtkSMPropertyHelper(display, "Representation").GetAsString() == this->GetType();
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
    const vtkColorArrayChoice choice(display);
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

void vtkSMScalarVolumeRepresentationProxy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "IsShown: " << this->IsShown << "\n";
  os << indent << "NeedsArray: " << this->NeedsArray << "\n";
  os << indent << "IsSolidByChoice: " << this->IsSolidByChoice << "\n";
}
