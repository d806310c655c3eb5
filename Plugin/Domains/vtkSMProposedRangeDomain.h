// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkSMProposedRangeDomain_h
#define vtkSMProposedRangeDomain_h

#include "InterlumeDomainsModule.h" // for the export macro
#include "vtkSMDoubleRangeDomain.h"

#include <string> // for the array's name
#include <vector> // for the values proposed

class vtkSMSourceProxy;

/**
 * @class   vtkSMProposedRangeDomain
 * @brief   the range of a point array, and values proposed from it for a row of a property
 *
 * This stands in place of ParaView's ArrayRangeDomain, which proposes one value for a property of
 * rows. The attribute `default_mode` has the proposal, one of min, mid, max for each value of a
 * row; required properties are Input and ArraySelection.
 *
 * - Default values, as at first and of the reset button: one row.
 * - Another array: values that are still those proposed are proposed anew; those that somebody has
 *   set stay.
 * - With the attribute `all_time_steps` set to 1 the range is that over all time steps of the
 * input. They are looked at when values are proposed, and known from then on. Where the time steps
 * take more than LargestSeries, the range is that of the time shown, and a warning says so.
 *
 * Values that are not finite do not count. The range is given for each value of a row.
 */
class INTERLUMEDOMAINS_EXPORT vtkSMProposedRangeDomain : public vtkSMDoubleRangeDomain
{
public:
  static vtkSMProposedRangeDomain* New();
  vtkTypeMacro(vtkSMProposedRangeDomain, vtkSMDoubleRangeDomain);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The largest size of all time steps together that are looked at, in kilobytes.
  static constexpr double LargestSeries = 8e6;

  void Update(vtkSMProperty* requesting) override;
  int SetDefaultValues(vtkSMProperty* property, bool useUnchecked) override;

protected:
  vtkSMProposedRangeDomain();
  ~vtkSMProposedRangeDomain() override;

  int ReadXMLAttributes(vtkSMProperty* property, vtkPVXMLElement* element) override;

  /// The array whose range is taken.
  struct Selection
  {
    vtkSMSourceProxy* Producer = nullptr;
    unsigned int Port = 0;
    int Association = 0;
    std::string Name;

    bool IsComplete() const { return this->Producer && !this->Name.empty(); }
    bool operator==(const Selection& other) const
    {
      return this->Producer == other.Producer && this->Port == other.Port &&
        this->Association == other.Association && this->Name == other.Name;
    }
  };

  Selection GetSelection();
  /// Returns the number of values in a row of the property.
  unsigned int GetRowSize();
  /// Finds the range of the array, at the time shown or over all time steps.
  bool FindRange(const Selection& selection, bool overTime, double range[2]);
  /// Returns whether all time steps can be looked at; warns where they are too large.
  bool CanLookAtAllTimes(const Selection& selection);
  void SetRange(const double range[2]);
  /// Returns the values proposed from the present range; none without a range.
  std::vector<double> Propose();
  bool IsAwaitingApply();

private:
  vtkSMProposedRangeDomain(const vtkSMProposedRangeDomain&) = delete;
  void operator=(const vtkSMProposedRangeDomain&) = delete;

  int AllTimeSteps = 0;
  Selection Known;
  // The range over all time steps of the selection that is known; the first is above the last
  // before it is looked at.
  double KnownOverTime[2] = { 1.0, 0.0 };
  std::vector<double> Proposed;
};

#endif
