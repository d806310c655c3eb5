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
  /// Fraction of the progress of an algorithm that is used for building the field if the algorithm
  /// also traces streamlines.
  static constexpr double BuildingPart = 0.1;

  /**
   * Builds the field and calls function(walker). The type of the walker depends on the type of
   * \a data. The walker is in no cell yet, and each thread must use its own copy. walker.GetField()
   * is valid until the function returns. \a arrays are one-component point arrays, which
   * Interpolate() identifies by index. Returns an error, without calling the function, if the field
   * is invalid. If the algorithm that owns \a progress was aborted, the function is not called
   * either.
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
    return data
      ? std::string(
          "the field must be an image or a rectilinear, structured or unstructured grid, not a ") +
        data->GetClassName()
      : "there is no dataset";
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
