// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkSMProposedStepsDomain_h
#define vtkSMProposedStepsDomain_h

#include "InterlumeDomainsModule.h" // for the export macro
#include "vtkSMDomain.h"

/**
 * @class   vtkSMProposedStepsDomain
 * @brief   proposes a stride of time steps with which an interval volume is not too large
 *
 * The required properties are Input, ArraySelection, Intervals, Range (first and last time step)
 * and Limit (number of tetrahedra). The proposed stride is the default value of a new proxy, and
 * the value that the reset button sets. If the stride would leave too few time steps, the range is
 * shortened too. Some time steps are read for the estimate. Nothing is proposed for series larger
 * than vtkArraySelection::MaximumSeriesSize.
 *
 * @sa vtkTimeVaryingIntervalVolume
 */
class INTERLUMEDOMAINS_EXPORT vtkSMProposedStepsDomain : public vtkSMDomain
{
public:
  static vtkSMProposedStepsDomain* New();
  vtkTypeMacro(vtkSMProposedStepsDomain, vtkSMDomain);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  int SetDefaultValues(vtkSMProperty* property, bool useUnchecked) override;

protected:
  vtkSMProposedStepsDomain();
  ~vtkSMProposedStepsDomain() override;

private:
  vtkSMProposedStepsDomain(const vtkSMProposedStepsDomain&) = delete;
  void operator=(const vtkSMProposedStepsDomain&) = delete;
};

#endif
