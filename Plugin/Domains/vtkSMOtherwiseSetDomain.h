// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkSMOtherwiseSetDomain_h
#define vtkSMOtherwiseSetDomain_h

#include "InterlumeDomainsModule.h" // for the export macro
#include "vtkSMDomain.h"

/**
 * @class   vtkSMOtherwiseSetDomain
 * @brief   turns a switch off once the value that it overrides is set
 *
 * For a switch such as "follow the time of the animation" beside a property for the time: whoever
 * sets the time, in the panel, in a script, by an animation or from a state file, means it. The
 * required property with the function Value is the one overridden. The switch in a state file
 * counts where it comes after the value there, which ParaView sorts by name.
 */
class INTERLUMEDOMAINS_EXPORT vtkSMOtherwiseSetDomain : public vtkSMDomain
{
public:
  static vtkSMOtherwiseSetDomain* New();
  vtkTypeMacro(vtkSMOtherwiseSetDomain, vtkSMDomain);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void Update(vtkSMProperty* requesting) override;

protected:
  vtkSMOtherwiseSetDomain();
  ~vtkSMOtherwiseSetDomain() override;

private:
  vtkSMOtherwiseSetDomain(const vtkSMOtherwiseSetDomain&) = delete;
  void operator=(const vtkSMOtherwiseSetDomain&) = delete;

  bool IsKnown = false;
  double Known = 0.0;
};

#endif
