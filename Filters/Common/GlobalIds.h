// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_GlobalIds_h
#define interlume_GlobalIds_h

#include "Common/ArrayCheck.h"
#include "Common/ArrayViews.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkPointData.h"

#include <string>

namespace interlume
{

/**
 * Access to global point ids, which may be integers of any type and layout.
 */
namespace GlobalIds
{
using Array = vtkAOSDataArrayTemplate<vtkIdType>;

/// Returns the global ids as vtkIdType, copied if necessary, or null if there are none.
inline vtkSmartPointer<Array> Get(vtkPointData* points)
{
  vtkDataArray* ids = points->GetGlobalIds();
  return ids ? ArrayViews::Get<Array>(ids) : vtkSmartPointer<Array>();
}

/// Returns an error if the global ids of \a data cannot be used to order its points. The message is
/// a clause.
inline Error FindError(vtkDataSet* data)
{
  vtkDataArray* ids = data->GetPointData()->GetGlobalIds();
  if (!ids)
  {
    return {};
  }
  Error error = ArrayCheck::FindPointError(data, ids, 1);
  const int type = ids->GetDataType();
  if (!error && (type == VTK_FLOAT || type == VTK_DOUBLE || type == VTK_BIT))
  {
    error = ArrayCheck::Describe(ids) + " is a " + ids->GetClassName() + "; integers are needed";
  }
  return error.Within("the global ids of the points cannot be used: ",
    ". Correct them, or remove them (vtkPointData::SetGlobalIds(nullptr))");
}
}

}

#endif
