#ifndef vtkFlowArrays_h
#define vtkFlowArrays_h

#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <array>
#include <map>
#include <string>

class vtkDataSet;

/**
 * @class   vtkFlowArrays
 * @brief   the arrays of vtkFlowStatus of a dataset, in the types they are defined with
 *
 * An array of another type, as an extraction leaves it, is copied.
 */
class vtkFlowArrays
{
public:
  /// What is missing or of the wrong shape, or nothing.
  std::string Find(vtkDataSet* data);

  bool IsReached(vtkIdType point) const { return this->Statuses->GetValue(point) == 0; }
  int GetId(vtkIdType point) const { return this->Ids->GetValue(point); }
  const double* GetParameters(vtkIdType point) const
  {
    return this->Parameters->GetPointer(2 * point);
  }

  /// The ids in use, and whether u and v are periodic there.
  const std::map<int, std::array<bool, 2>>& GetSurfaces() const { return this->Surfaces; }
  /// The same of an id; false twice of one that is not in use.
  std::array<bool, 2> GetPeriodicity(int id) const;

  /**
   * The tuples of a field array of three integers, an id and a flag for u and v:
   * TerminationSurfaces, InflowPeriodic. Empty where \a data has none.
   */
  static std::map<int, std::array<bool, 2>> ReadFlags(vtkDataSet* data, const char* name);

private:
  vtkSmartPointer<vtkUnsignedCharArray> Statuses;
  vtkSmartPointer<vtkIntArray> Ids;
  vtkSmartPointer<vtkDoubleArray> Parameters;
  std::map<int, std::array<bool, 2>> Surfaces;
};

#endif
