// SPDX-License-Identifier: BSD-3-Clause
#include "vtkConstantScalars.h"

#include "vtkDataSet.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkTrivialProducer.h"
#include "vtkUnsignedCharArray.h"

vtkConstantScalars::vtkConstantScalars() = default;

vtkConstantScalars::~vtkConstantScalars() = default;

const char* vtkConstantScalars::GetArrayName()
{
  return "InterlumeConstant";
}

vtkTrivialProducer* vtkConstantScalars::Update(vtkDataSet* data)
{
  if (this->Source == data && this->SourceTime == data->GetMTime())
  {
    return this->Producer;
  }
  this->Source = data;
  this->SourceTime = data->GetMTime();
  vtkNew<vtkUnsignedCharArray> zeros;
  zeros->SetName(GetArrayName());
  zeros->SetNumberOfValues(data->GetNumberOfPoints());
  zeros->FillValue(0);
  const auto copy = vtkSmartPointer<vtkDataSet>::Take(data->NewInstance());
  copy->ShallowCopy(data);
  copy->GetPointData()->AddArray(zeros);
  this->Producer->SetOutput(copy);
  return this->Producer;
}
