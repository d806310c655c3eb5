// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkSMInputInitializationHelper_h
#define vtkSMInputInitializationHelper_h

#include "InterlumeDomainsModule.h" // for the export macro
#include "vtkSMProxyInitializationHelper.h"

/**
 * @class   vtkSMInputInitializationHelper
 * @brief   selects inputs of a new filter that follow from its first input
 *
 * Attributes of the XML hint InitializationHelper, each of which may be omitted:
 *
 * - output: name of the output of the input's source to which the filter connects. Only the first
 *   output, which the client selects with the source, is replaced. When the new filter first has
 *   data, displays of the first output are hidden, as ParaView hides an input.
 * - field: name of a second input property. If nothing is connected, the nearest suitable output
 *   upstream of the first input is used. The attribute array names the property that selects one of
 *   its arrays.
 * - time: name of a property that is set to the current time, clamped to the range of the point
 *   array of that name, or to the times of the data. The attribute toggle names a property that
 *   keeps its value.
 *
 * Properties set explicitly remain unchanged.
 */
class INTERLUMEDOMAINS_EXPORT vtkSMInputInitializationHelper : public vtkSMProxyInitializationHelper
{
public:
  static vtkSMInputInitializationHelper* New();
  vtkTypeMacro(vtkSMInputInitializationHelper, vtkSMProxyInitializationHelper);

  void PostInitializeProxy(
    vtkSMProxy* proxy, vtkPVXMLElement* xml, vtkMTimeType initializationTimeStamp) override;

protected:
  vtkSMInputInitializationHelper();
  ~vtkSMInputInitializationHelper() override;

private:
  vtkSMInputInitializationHelper(const vtkSMInputInitializationHelper&) = delete;
  void operator=(const vtkSMInputInitializationHelper&) = delete;
};

#endif
