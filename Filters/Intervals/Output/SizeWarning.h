// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SizeWarning_h
#define interlume_SizeWarning_h

#include "vtkType.h"

#include <string>

class vtkAlgorithm;

namespace interlume
{

/**
 * @class   SizeWarning
 * @brief   warns once per execution that an output will be large, before it is allocated
 *
 * An output is large if it has more tetrahedra than a limit, or needs more than a quarter of the
 * memory.
 */
class SizeWarning
{
public:
  /// \a limit is a number of tetrahedra; 0 turns the warning off. \a memory is in bytes.
  SizeWarning(vtkAlgorithm* owner, vtkIdType limit, double memory = GetMachineMemory());

  /// Returns the memory in bytes that this process can use: the physical memory, or the limit of
  /// its control group if that is lower. Returns 0 if it is unknown.
  static double GetMachineMemory();

  /// Returns true if the warning is on and has not been issued.
  bool IsPending() const { return this->Limit > 0 && !this->IsIssued; }

  /// Returns the size divided by the lower of the two limits.
  double GetExcess(double tetrahedra, double bytes) const;

  struct Size
  {
    double Tetrahedra = 0.0;
    double Bytes = 0.0;
    /// Words before the number of tetrahedra, such as "about ", and after it.
    std::string Qualifier;
    std::string Basis;
    /// Sentence on how to reduce the size.
    std::string Advice;
    /// Name of the cells.
    std::string Cells = "tetrahedra";
  };

  /// Warns if the size exceeds a limit.
  void Check(const Size& size);

  /// Adds the size of a dataset and warns if the sum exceeds a limit. \a cells is the name of its
  /// cells.
  void Add(double tetrahedra, double bytes, const std::string& advice,
    const std::string& cells = "tetrahedra");

private:
  vtkAlgorithm* Owner;
  double Limit;
  double Memory;
  // The sums of Add().
  Size Sum;
  bool IsIssued = false;
};

}

#endif
