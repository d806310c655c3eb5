#ifndef vtkFlowDispatch_h
#define vtkFlowDispatch_h

#include "vtkImageData.h"
#include "vtkImageFlowWalker.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredFlowWalker.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredFlowWalker.h"
#include "vtkUnstructuredGrid.h"

#include <string>
#include <vector>

/**
 * @class   vtkFlowDispatch
 * @brief   builds the field of a dataset and calls a function with its walker
 */
class vtkFlowDispatch
{
public:
  /**
   * Calls function(walker), where \a walker, of the kind that \a data needs, stands nowhere yet.
   * Each thread works with a copy. walker.GetField() has the speed, the bounds and what else is
   * known of the field, which lasts until the function returns. \a arrays are point arrays of one
   * component, by number for Interpolate. Returns what is wrong with the field, the function not
   * being called, or nothing.
   */
  template <typename Function>
  static std::string Execute(vtkDataSet* data, vtkDataArray* vectors,
    const std::vector<vtkDataArray*>& arrays, Function&& function)
  {
    if (auto* image = vtkImageData::SafeDownCast(data))
    {
      return Run<vtkImageFlowWalker>(image, vectors, arrays, function);
    }
    if (auto* rectilinear = vtkRectilinearGrid::SafeDownCast(data))
    {
      return Run<vtkRectilinearFlowWalker>(rectilinear, vectors, arrays, function);
    }
    if (auto* structured = vtkStructuredGrid::SafeDownCast(data))
    {
      return Run<vtkStructuredFlowWalker>(structured, vectors, arrays, function);
    }
    if (auto* unstructured = vtkUnstructuredGrid::SafeDownCast(data))
    {
      return Run<vtkUnstructuredFlowWalker>(unstructured, vectors, arrays, function);
    }
    return data ? std::string("a field is no ") + data->GetClassName() : "there is no dataset";
  }

private:
  template <typename Walker, typename Data, typename Function>
  static std::string Run(
    Data* data, vtkDataArray* vectors, const std::vector<vtkDataArray*>& arrays, Function& function)
  {
    typename Walker::Field field;
    std::string error = field.Build(data, vectors, arrays);
    if (error.empty())
    {
      function(Walker(&field));
    }
    return error;
  }
};

#endif
