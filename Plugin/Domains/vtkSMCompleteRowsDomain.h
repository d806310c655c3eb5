// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkSMCompleteRowsDomain_h
#define vtkSMCompleteRowsDomain_h

#include "InterlumeDomainsModule.h" // for the export macro
#include "vtkSMDomain.h"

/**
 * @class   vtkSMCompleteRowsDomain
 * @brief   warns if the last row of a repeatable property is incomplete
 *
 * ParaView silently ignores an incomplete row. This domain checks the property when its values are
 * sent to the server. The warning reports the property, the number of values in the row and the
 * required number. It is repeated only if the number of values changes.
 */
class INTERLUMEDOMAINS_EXPORT vtkSMCompleteRowsDomain : public vtkSMDomain
{
public:
  static vtkSMCompleteRowsDomain* New();
  vtkTypeMacro(vtkSMCompleteRowsDomain, vtkSMDomain);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkSMCompleteRowsDomain();
  ~vtkSMCompleteRowsDomain() override;

  int ReadXMLAttributes(vtkSMProperty* property, vtkPVXMLElement* element) override;
  /// Starts observing the proxy, which signals when it sends values to the server.
  void ObserveUpdates();
  /// Warns if the last row is incomplete.
  void WarnIfIncomplete();

private:
  vtkSMCompleteRowsDomain(const vtkSMCompleteRowsDomain&) = delete;
  void operator=(const vtkSMCompleteRowsDomain&) = delete;

  bool IsObserving = false;
  /// Number of values at the last warning; 0 if the rows have been complete since.
  unsigned int LastIncompleteSize = 0;
};

#endif
