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
 * Reads the global ids of points, which may be integers of any type and layout.
 */
namespace GlobalIds
{
using Array = vtkAOSDataArrayTemplate<vtkIdType>;

/// Returns the global ids, copied if they are of another type, or null without global ids.
inline vtkSmartPointer<Array> Get(vtkPointData* points)
{
  vtkDataArray* ids = points->GetGlobalIds();
  return ids ? ArrayViews::Get<Array>(ids) : vtkSmartPointer<Array>();
}

/// Returns an error, whose message is a part of a sentence, if global ids cannot order the points
/// of \a data.
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
