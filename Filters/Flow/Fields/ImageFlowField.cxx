// SPDX-License-Identifier: BSD-3-Clause
#include "Fields/ImageFlowField.h"

#include "Cells/MultilinearCell.h"
#include "Common/Vectors.h"

#include "vtkImageData.h"
#include "vtkMatrix4x4.h"

#include <cfloat>
#include <cmath>

namespace interlume
{

Error ImageFlowField::Build(vtkImageData* image, vtkDataArray* vectors,
  const std::vector<vtkDataArray*>& arrays, const StageProgress& progress,
  const FieldPartition* part)
{
  int points[3];
  image->GetDimensions(points);
  if (Error error = this->BuildTopologyAndArrays(image, points, vectors, arrays, progress, part))
  {
    return error;
  }
  vtkImageData* fullImage = part ? vtkImageData::SafeDownCast(part->FullGrid) : image;
  vtkMatrix4x4* matrix = fullImage->GetIndexToPhysicalMatrix();
  const int* extent = fullImage->GetExtent();
  glm::dmat3 columns;
  for (int i = 0; i < 3; ++i)
  {
    this->Origin[i] = matrix->GetElement(i, 3);
    for (int j = 0; j < 3; ++j)
    {
      this->Axes[i][j] = matrix->GetElement(i, j);
      columns[j][i] = this->Axes[i][j];
      this->Origin[i] += this->Axes[i][j] * extent[2 * j];
    }
  }
  // The inverse is computed from cross products of the columns. Scaling the columns to a
  // length of about 1 avoids overflow for any spacing.
  double scales[3];
  for (int j = 0; j < 3; ++j)
  {
    scales[j] = MultilinearCell::GetScale(Vectors::InfinityNorm(columns[j]));
    columns[j] *= scales[j];
  }
  for (int i = 0; i < 3; ++i)
  {
    const glm::dvec3 normal = glm::cross(columns[(i + 1) % 3], columns[(i + 2) % 3]);
    const double volume = glm::dot(columns[i], normal);
    const double* bounds = this->GetBounds();
    double rounding = 0.0;
    for (int j = 0; j < 3; ++j)
    {
      this->Inverse[i][j] = normal[j] / volume * scales[i];
      rounding += std::abs(this->Inverse[i][j]) *
        std::max(std::abs(bounds[2 * j]), std::abs(bounds[2 * j + 1]));
    }
    if (!std::isfinite(rounding))
    {
      return "the image's spacing or direction matrix is singular or not finite";
    }
    this->Slack[i] = 1e-12 + 8.0 * DBL_EPSILON * rounding;
  }
  return {};
}

void ImageFlowField::GetContinuousIndex(const double x[3], double q[3]) const
{
  const double d[3] = { x[0] - this->Origin[0], x[1] - this->Origin[1], x[2] - this->Origin[2] };
  for (int i = 0; i < 3; ++i)
  {
    const double* row = this->Inverse[i];
    q[i] = row[0] * d[0] + row[1] * d[1] + row[2] * d[2];
  }
}

bool ImageFlowField::Locate(const double x[3], CellLocation& location, double p[3]) const
{
  double q[3];
  this->GetContinuousIndex(x, q);
  return this->Find(q, this->Slack, location, p);
}

bool ImageFlowField::LocateIndex(const double x[3], int index[3], double p[3]) const
{
  double q[3];
  this->GetContinuousIndex(x, q);
  return this->FindIndex(q, this->Slack, index, p);
}

}
