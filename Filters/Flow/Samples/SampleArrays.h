// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SampleArrays_h
#define interlume_SampleArrays_h

#include "Advection/AdvectionOptions.h"

#include "vtkType.h"

#include <string>
#include <vector>

class vtkDoubleArray;
class vtkFieldData;
class vtkIntArray;
class vtkSignedCharArray;
class vtkUnsignedCharArray;

namespace interlume
{

/**
 * @class   SampleArrays
 * @brief   writes the results of samples into arrays of vtkFlowStatus, and reads them
 */
class SampleArrays
{
public:
  /// Adds the arrays that the settings need to point data of samples, or to field data of far-side
  /// samples, with names that begin with \a prefix.
  static SampleArrays Make(const vtkFlowSettings& settings, vtkFieldData* data, vtkIdType number,
    const std::string& prefix = {});
  /// Finds the arrays that Make added.
  static SampleArrays Find(const vtkFlowSettings& settings, vtkFieldData* data);

  void Set(vtkIdType id, const AdvectionResult& result);
  AdvectionResult Get(vtkIdType id) const;

  vtkUnsignedCharArray* Status = nullptr;
  vtkIntArray* Id = nullptr;
  vtkDoubleArray* Parameters = nullptr;
  vtkDoubleArray* Time = nullptr;
  vtkSignedCharArray* Side = nullptr;

private:
  /// Calls visit(array, name, components) for the arrays that the settings need.
  template <typename Visit>
  void ForEach(const vtkFlowSettings& settings, Visit&& visit);
  /// Calls visit(array, value) for the further quantities of a result that are kept.
  template <typename Result, typename Visit>
  void ForEachQuantity(Result& result, Visit&& visit) const;

  // The arrays of further quantities and of numbers of steps; those that are not kept are null.
  vtkDoubleArray* MaximumSpeed = nullptr;
  vtkDoubleArray* ArcLength = nullptr;
  vtkDoubleArray* MeanVorticity = nullptr;
  std::vector<vtkDoubleArray*> Means;
  vtkIntArray* Steps = nullptr;
  vtkIntArray* StiffSteps = nullptr;
};

}

#endif
