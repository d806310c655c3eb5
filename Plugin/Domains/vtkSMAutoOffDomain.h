// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkSMAutoOffDomain_h
#define vtkSMAutoOffDomain_h

#include "InterlumeDomainsModule.h" // for the export macro
#include "vtkSMDomain.h"

/**
 * @class   vtkSMAutoOffDomain
 * @brief   turns a Boolean property off when the value that it overrides is set
 *
 * Use it for a property such as UseAnimationTime, which overrides the property Time. Setting Time
 * in the panel, in a script, by an animation or from a state file turns UseAnimationTime off. The
 * overridden property is the required property with the function Value.
 *
 * ParaView sorts the properties of a state file by name. If the Boolean property comes after the
 * overridden property, it is restored later and keeps its state from the file.
 */
class INTERLUMEDOMAINS_EXPORT vtkSMAutoOffDomain : public vtkSMDomain
{
public:
  static vtkSMAutoOffDomain* New();
  vtkTypeMacro(vtkSMAutoOffDomain, vtkSMDomain);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void Update(vtkSMProperty* requesting) override;

protected:
  vtkSMAutoOffDomain();
  ~vtkSMAutoOffDomain() override;

private:
  vtkSMAutoOffDomain(const vtkSMAutoOffDomain&) = delete;
  void operator=(const vtkSMAutoOffDomain&) = delete;

  bool HasLastValue = false;
  double LastValue = 0.0;
};

#endif
