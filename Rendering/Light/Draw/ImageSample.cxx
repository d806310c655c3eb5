// SPDX-License-Identifier: BSD-3-Clause
#include "Draw/ImageSample.h"

#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace interlume
{

void ImageSample::Update(vtkImageData* image, vtkDataArray* scalars)
{
  const vtkMTimeType time = std::max(image->GetMTime(), scalars->GetMTime());
  if (this->Input == image && this->InputScalars == scalars && this->InputTime == time)
  {
    return;
  }
  this->Input = image;
  this->InputScalars = scalars;
  this->InputTime = time;
  this->Stride =
    static_cast<int>(std::ceil(std::cbrt(static_cast<double>(image->GetNumberOfPoints()) / SIZE)));
  const int* size = image->GetDimensions();
  const int* extent = image->GetExtent();
  const double* spacing = image->GetSpacing();
  std::array<int, 3> sampled{};
  std::array<double, 3> steps{};
  for (int i = 0; i < 3; ++i)
  {
    sampled[i] = (size[i] - 1) / this->Stride + 1;
    steps[i] = this->Stride * spacing[i];
  }
  vtkNew<vtkIdList> points;
  for (int z = 0; z < size[2]; z += this->Stride)
  {
    for (int y = 0; y < size[1]; y += this->Stride)
    {
      for (int x = 0; x < size[0]; x += this->Stride)
      {
        points->InsertNextId((static_cast<vtkIdType>(z) * size[1] + y) * size[0] + x);
      }
    }
  }
  auto values = vtkSmartPointer<vtkDataArray>::Take(scalars->NewInstance());
  values->SetNumberOfComponents(scalars->GetNumberOfComponents());
  values->SetNumberOfTuples(points->GetNumberOfIds());
  scalars->GetTuples(points, values);
  std::array<double, 3> origin{};
  image->TransformIndexToPhysicalPoint(extent[0], extent[2], extent[4], origin.data());
  this->Image = vtkSmartPointer<vtkImageData>::New();
  this->Image->SetDimensions(sampled.data());
  this->Image->SetSpacing(steps.data());
  this->Image->SetOrigin(origin.data());
  this->Image->SetDirectionMatrix(image->GetDirectionMatrix());
  this->Image->GetPointData()->SetScalars(values);
}

}
