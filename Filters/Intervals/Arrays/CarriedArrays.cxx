// SPDX-License-Identifier: BSD-3-Clause
#include "Arrays/CarriedArrays.h"

#include "Arrays/ExtractionArrays.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

namespace interlume
{

CarriedArrays::CarriedArrays(vtkDataSet* input, int precision)
  : Input(input)
{
  this->Points.TakeReference(vtkPoints::New(ExtractionArrays::ChoosePointType(input, precision)));
  vtkPointData* arrays = input->GetPointData();
  for (int a = 0; a < arrays->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* in = arrays->GetAbstractArray(a);
    if (ExtractionArrays::IsCarried(arrays, in))
    {
      this->Arrays.push_back({ in, ExtractionArrays::NewInterpolated(in, 0) });
      this->Others |= !vtkDataArray::SafeDownCast(in);
    }
  }
}

void CarriedArrays::AddTo(vtkPointData* output) const
{
  for (const Carried& array : this->Arrays)
  {
    ExtractionArrays::AddLike(this->Input->GetPointData(), array.In, output, array.Out);
  }
}

}
