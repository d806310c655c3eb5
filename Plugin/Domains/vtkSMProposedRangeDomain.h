// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkSMProposedRangeDomain_h
#define vtkSMProposedRangeDomain_h

#include "InterlumeDomainsModule.h" // for the export macro
#include "vtkArraySelection.h"      // for the selected array
#include "vtkSMDoubleRangeDomain.h"

#include <vector> // for the proposed values

/**
 * @class   vtkSMProposedRangeDomain
 * @brief   proposes the values of a repeatable property from the range of an array
 *
 * ParaView's ArrayRangeDomain proposes a single value, even if a row of the property has several.
 * This domain proposes one complete row. The XML attribute `default_mode` lists min, mid or max for
 * each value of the row. The required properties are Input and ArraySelection.
 *
 * - The proposed row is the default value of a new proxy, and the value that the reset button sets.
 * - If another array is selected, a new row is proposed. Values that the user has set are not
 *   replaced.
 * - If the XML attribute `all_time_steps` is 1, the range covers all time steps of the input. The
 *   steps are read when values are proposed, and the range is cached. If all steps together exceed
 *   MaximumSeriesSize, a warning reports this, and the range of the current time step is used.
 *
 * Non-finite values are ignored. All values of a row have the same range.
 */
class INTERLUMEDOMAINS_EXPORT vtkSMProposedRangeDomain : public vtkSMDoubleRangeDomain
{
public:
  static vtkSMProposedRangeDomain* New();
  vtkTypeMacro(vtkSMProposedRangeDomain, vtkSMDoubleRangeDomain);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void Update(vtkSMProperty* requesting) override;
  int SetDefaultValues(vtkSMProperty* property, bool useUnchecked) override;

protected:
  vtkSMProposedRangeDomain();
  ~vtkSMProposedRangeDomain() override;

  int ReadXMLAttributes(vtkSMProperty* property, vtkPVXMLElement* element) override;

  /// Returns the number of values in a row of the property.
  unsigned int GetRowSize();
  /// Computes the range of the array in the current time step or in all time steps. Returns false
  /// if the array is missing, has several components or has no finite value.
  bool FindRange(const vtkArraySelection& selection, bool overTime, double range[2]);
  /// Returns true if there are several time steps and their total size is at most
  /// vtkArraySelection::MaximumSeriesSize. Warns once if it is larger.
  bool CanReadAllTimeSteps(const vtkArraySelection& selection);
  void SetRange(const double range[2]);
  /// Returns the row proposed for the current range; empty if there is no range.
  std::vector<double> ComputeProposedValues();
  bool IsAwaitingApply();

private:
  vtkSMProposedRangeDomain(const vtkSMProposedRangeDomain&) = delete;
  void operator=(const vtkSMProposedRangeDomain&) = delete;

  int AllTimeSteps = 0;
  vtkArraySelection LastSelection;
  vtkArraySelection WarnedSelection;
  // Cached range of LastSelection over all time steps; empty (lower > upper) until all steps have
  // been read.
  double RangeOverTime[2] = { 1.0, 0.0 };
  std::vector<double> Proposed;
};

#endif
