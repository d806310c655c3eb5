// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Meshes/ReferenceField.h"

#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <functional>
#include <random>

namespace reference
{

namespace
{

vtkDoubleArray* AddField(
  vtkDataSet* data, const char* name, const std::function<double(vtkIdType)>& value)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfTuples(data->GetNumberOfPoints());
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    array->SetValue(i, value(i));
  }
  // SetScalars would remove the previous active array.
  data->GetPointData()->AddArray(array);
  data->GetPointData()->SetActiveScalars(name);
  return vtkDoubleArray::SafeDownCast(data->GetPointData()->GetArray(name));
}

}

vtkDoubleArray* AddRandomField(vtkDataSet* data, unsigned int seed, const char* name)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  return AddField(data, name, [&](vtkIdType) { return uniform(random); });
}

vtkDoubleArray* AddIntegerField(vtkDataSet* data, int values, unsigned int seed, const char* name)
{
  std::mt19937 random(seed);
  return AddField(data, name, [&](vtkIdType) { return static_cast<double>(random() % values); });
}

vtkDoubleArray* AddLinearField(vtkDataSet* data, const LinearFunction& function, const char* name)
{
  return AddField(data, name,
    [&](vtkIdType i)
    {
      double x[3];
      data->GetPoint(i, x);
      return function(x);
    });
}

void SetGhost(vtkDataSetAttributes* attributes, vtkIdType size, vtkIdType at, unsigned char value)
{
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfTuples(size);
  ghosts->FillValue(0);
  ghosts->SetValue(at, value);
  attributes->AddArray(ghosts);
}

}
