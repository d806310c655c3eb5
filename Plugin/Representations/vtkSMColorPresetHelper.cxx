// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMColorPresetHelper.h"

#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPVXMLElement.h"
#include "vtkSMProxy.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSettings.h"
#include "vtkSMTransferFunctionManager.h"
#include "vtkSMTransferFunctionProxy.h"

#include <string>

vtkStandardNewMacro(vtkSMColorPresetHelper);

void vtkSMColorPresetHelper::PostInitializeProxy(
  vtkSMProxy* proxy, vtkPVXMLElement* xml, vtkMTimeType)
{
  const std::string array = xml->GetAttributeOrEmpty("array");
  vtkSMSessionProxyManager* manager = proxy->GetSessionProxyManager();
  // ParaView registers color maps under these names.
  const bool exists = manager->GetProxy("lookup_tables", (array + ".PVLookupTable").c_str());
  const bool isChosen =
    vtkSMSettings::GetInstance()->HasSetting((".standard_presets." + array).c_str());
  if (exists || isChosen)
  {
    return;
  }
  vtkNew<vtkSMTransferFunctionManager> colors;
  vtkSMTransferFunctionProxy::ApplyPreset(
    colors->GetColorTransferFunction(array.c_str(), manager), xml->GetAttributeOrEmpty("preset"));
}
