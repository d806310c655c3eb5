// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkSMWholeRowsDomain_h
#define vtkSMWholeRowsDomain_h

#include "InterlumeDomainsModule.h" // for the export macro
#include "vtkSMDomain.h"

/**
 * @class   vtkSMWholeRowsDomain
 * @brief   warns of a property of rows whose last row is not whole
 *
 * ParaView leaves such a row out in silence. The warning names the property, how many values the
 * row has, and how many it needs. It is given when the values go to the filter, and once for the
 * same number of values.
 */
class INTERLUMEDOMAINS_EXPORT vtkSMWholeRowsDomain : public vtkSMDomain
{
public:
  static vtkSMWholeRowsDomain* New();
  vtkTypeMacro(vtkSMWholeRowsDomain, vtkSMDomain);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkSMWholeRowsDomain();
  ~vtkSMWholeRowsDomain() override;

  int ReadXMLAttributes(vtkSMProperty* property, vtkPVXMLElement* element) override;
  /// Waits for the values to be sent to the filter.
  void Watch();
  void Check();

private:
  vtkSMWholeRowsDomain(const vtkSMWholeRowsDomain&) = delete;
  void operator=(const vtkSMWholeRowsDomain&) = delete;

  bool IsWatching = false;
  unsigned int SaidOf = 0;
};

#endif
