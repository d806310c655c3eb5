// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkArraySelection_h
#define vtkArraySelection_h

#include <string>

class vtkSMDomain;
class vtkSMSourceProxy;

/**
 * @class   vtkArraySelection
 * @brief   the input and the array that a filter's properties select
 */
struct vtkArraySelection
{
  /// Returns the selection by the domain's required properties Input and ArraySelection.
  static vtkArraySelection Find(vtkSMDomain* domain);

  vtkSMSourceProxy* Producer = nullptr;
  unsigned int Port = 0;
  int Association = 0;
  std::string Name;

  bool IsComplete() const { return this->Producer && !this->Name.empty(); }
  bool operator==(const vtkArraySelection& other) const
  {
    return this->Producer == other.Producer && this->Port == other.Port &&
      this->Association == other.Association && this->Name == other.Name;
  }

  /// Maximum total size of the time steps, in kilobytes, up to which they are read.
  static constexpr double MaximumSeriesSize = 8e6;

  /// Returns the number of time steps of the input, or 0 if it is not temporal.
  int GetNumberOfTimeSteps() const;
  /// Returns the total size of the time steps in kilobytes.
  double GetSeriesSize() const;
};

#endif
