// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkSMColorPresetHelper_h
#define vtkSMColorPresetHelper_h

#include "InterlumeRepresentationsModule.h" // for the export macro
#include "vtkSMProxyInitializationHelper.h"

/**
 * @class   vtkSMColorPresetHelper
 * @brief   sets the color map with which an array of a new filter is first shown
 *
 * Attributes of the XML hint InitializationHelper: array is the name of the array, preset the name
 * of one of ParaView's color maps. The color map is set before the array is shown for the first
 * time. If the array already has a color map, or a preset in the user's settings, nothing is
 * changed.
 */
class INTERLUMEREPRESENTATIONS_EXPORT vtkSMColorPresetHelper : public vtkSMProxyInitializationHelper
{
public:
  static vtkSMColorPresetHelper* New();
  vtkTypeMacro(vtkSMColorPresetHelper, vtkSMProxyInitializationHelper);

  void PostInitializeProxy(
    vtkSMProxy* proxy, vtkPVXMLElement* xml, vtkMTimeType initializationTimeStamp) override;

protected:
  vtkSMColorPresetHelper() = default;
  ~vtkSMColorPresetHelper() override = default;

private:
  vtkSMColorPresetHelper(const vtkSMColorPresetHelper&) = delete;
  void operator=(const vtkSMColorPresetHelper&) = delete;
};

#endif
