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
 * @brief   writes and reads advection results in the arrays of vtkFlowStatus
 */
class SampleArrays
{
public:
  /// Adds the arrays that the settings require to \a data: the point data of the samples or, with
  /// \a prefix before the names, the field data for far-side values.
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
  /// Calls visit(array, name, components) for the arrays that the settings require.
  template <typename Visit>
  void ForEach(const vtkFlowSettings& settings, Visit&& visit);
  /// Calls visit(array, value) for the optional quantities that are stored.
  template <typename Result, typename Visit>
  void ForEachQuantity(Result& result, Visit&& visit) const;

  // Arrays of optional quantities and step counts; null if not stored.
  vtkDoubleArray* MaximumSpeed = nullptr;
  vtkDoubleArray* ArcLength = nullptr;
  vtkDoubleArray* MeanVorticity = nullptr;
  std::vector<vtkDoubleArray*> Means;
  vtkIntArray* Steps = nullptr;
  vtkIntArray* StiffSteps = nullptr;
};

}

#endif
