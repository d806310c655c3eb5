// SPDX-License-Identifier: BSD-3-Clause
#include "vtkImageComponent.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkTrivialProducer.h"

#include <cmath>
#include <tuple>

vtkImageComponent::vtkImageComponent() = default;

vtkImageComponent::~vtkImageComponent() = default;

bool vtkImageComponent::Key::operator==(const Key& other) const
{
  const auto all = [](const Key& key)
  { return std::tie(key.Array, key.Time, key.ImageTime, key.IsOfPoints, key.Component); };
  return all(*this) == all(other);
}

vtkTrivialProducer* vtkImageComponent::Update(
  vtkImageData* image, vtkDataArray* array, bool isOfPoints, int component)
{
  const Key key{ array, array->GetMTime(), image->GetMTime(), isOfPoints, component };
  if (this->LastKey == key)
  {
    return this->Producer;
  }
  this->LastKey = key;
  const int type = array->GetDataType() == VTK_DOUBLE ? VTK_DOUBLE : VTK_FLOAT;
  const auto values = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  values->SetName(array->GetName());
  values->SetNumberOfTuples(array->GetNumberOfTuples());
  vtkSMPTools::For(0, array->GetNumberOfTuples(),
    [&](vtkIdType begin, vtkIdType end)
    {
      vtkIdType i = begin;
      for (const auto tuple : vtk::DataArrayTupleRange(array, begin, end))
      {
        double value = 0.0;
        if (component >= 0)
        {
          value = tuple[component];
        }
        else
        {
          for (const double x : tuple)
          {
            value += x * x;
          }
          value = std::sqrt(value);
        }
        values->SetComponent(i++, 0, value);
      }
    });
  vtkNew<vtkImageData> result;
  result->CopyStructure(image);
  (isOfPoints ? static_cast<vtkDataSetAttributes*>(result->GetPointData()) : result->GetCellData())
    ->AddArray(values);
  this->Producer->SetOutput(result);
  return this->Producer;
}
