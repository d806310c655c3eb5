// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FieldDispatch_h
#define interlume_FieldDispatch_h

#include "Common/Error.h"
#include "Common/StageProgress.h"
#include "Fields/ImageWalker.h"
#include "Fields/StructuredWalker.h"
#include "Fields/UnstructuredWalker.h"

#include "vtkImageData.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"

#include <string>
#include <vector>

namespace interlume
{

/**
 * @class   FieldDispatch
 * @brief   builds the field of a dataset and calls a function with its walker
 */
class FieldDispatch
{
public:
  /// The part of the progress of an algorithm that follows streamlines which building the field
  /// takes.
  static constexpr double BuildingPart = 0.1;

  /**
   * Calls function(walker), where \a walker, of the kind that \a data needs, stands nowhere yet.
   * Each thread works with a copy. walker.GetField() has the speed, the bounds and what else is
   * known of the field, which lasts until the function returns. \a arrays are point arrays of one
   * component, by number for Interpolate. Returns an error, without calling the function, if the
   * field cannot be used. Nor is it called when the owner of \a progress, which is that of building
   * the field, was aborted before.
   */
  template <typename Function>
  static Error Execute(vtkDataSet* data, vtkDataArray* vectors,
    const std::vector<vtkDataArray*>& arrays, Function&& function,
    const StageProgress& progress = {})
  {
    if (auto* image = vtkImageData::SafeDownCast(data))
    {
      return Run<ImageWalker>(image, vectors, arrays, progress, function);
    }
    if (auto* rectilinear = vtkRectilinearGrid::SafeDownCast(data))
    {
      return Run<RectilinearWalker>(rectilinear, vectors, arrays, progress, function);
    }
    if (auto* structured = vtkStructuredGrid::SafeDownCast(data))
    {
      return Run<StructuredWalker>(structured, vectors, arrays, progress, function);
    }
    if (auto* unstructured = vtkUnstructuredGrid::SafeDownCast(data))
    {
      return Run<UnstructuredWalker>(unstructured, vectors, arrays, progress, function);
    }
    return data ? std::string("a field is no ") + data->GetClassName() : "there is no dataset";
  }

private:
  template <typename Walker, typename Data, typename Function>
  static Error Run(Data* data, vtkDataArray* vectors, const std::vector<vtkDataArray*>& arrays,
    const StageProgress& progress, Function& function)
  {
    typename Walker::Field field;
    Error error = field.Build(data, vectors, arrays, progress);
    if (!error && progress.Reach(1.0))
    {
      function(Walker(&field));
    }
    return error;
  }
};

}

#endif
