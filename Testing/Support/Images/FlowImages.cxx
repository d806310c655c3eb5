// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Images/FlowImages.h"

#include "Support/Arrays/ReferenceIndices.h"
#include "Support/Images/ReferenceRay.h"

#include "vtkCamera.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>

namespace reference
{

namespace
{
constexpr double HALF = 0.5;

template <typename Array>
Array* AddArray(vtkFieldData* data, const char* name, int components, vtkIdType tuples)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  data->AddArray(array);
  return array;
}
}

vtkSmartPointer<vtkImageData> MakeFlowVoxels(
  int n, const FlowFormula& flow, const std::vector<std::array<int, 3>>& surfaces)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  const double spacing = 1.0 / (n - 1);
  image->SetDimensions(n, n, n);
  image->SetOrigin(-HALF, -HALF, -HALF);
  image->SetSpacing(spacing, spacing, spacing);
  const vtkIdType number = image->GetNumberOfPoints();
  auto* status = AddArray<vtkUnsignedCharArray>(image->GetPointData(), "FlowStatus", 1, number);
  auto* ids = AddArray<vtkIntArray>(image->GetPointData(), "TerminationId", 1, number);
  auto* coordinates = AddArray<vtkDoubleArray>(image->GetPointData(), "TerminationUV", 2, number);
  auto* times = AddArray<vtkDoubleArray>(image->GetPointData(), "AdvectionTime", 1, number);
  for (vtkIdType i = 0; i < number; ++i)
  {
    Position3 x;
    image->GetPoint(i, x.data());
    const FlowEnd end = flow(x);
    status->SetValue(i, end.IsReached ? 0 : 1);
    ids->SetValue(i, end.IsReached ? end.Id : -1);
    coordinates->SetTuple2(i, end.IsReached ? end.U : 0.0, end.IsReached ? end.V : 0.0);
    times->SetValue(i, end.Time);
  }
  auto* periods = AddArray<vtkIntArray>(
    image->GetFieldData(), "TerminationSurfaces", 3, static_cast<vtkIdType>(surfaces.size()));
  for (std::size_t i = 0; i < surfaces.size(); ++i)
  {
    periods->SetTypedTuple(static_cast<vtkIdType>(i), surfaces[i].data());
  }
  return image;
}

vtkSmartPointer<vtkImageData> MakePaint(
  int columns, int rows, const std::function<Color4(double u, double v)>& paint)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(columns, rows, 1);
  image->AllocateScalars(VTK_FLOAT, 4);
  for (const auto& [j, i] : AllIndices(rows, columns))
  {
    const Color4 color = paint(i / (columns - 1.0), j / (rows - 1.0));
    for (int c = 0; c < 4; ++c)
    {
      image->SetScalarComponentFromDouble(i, j, 0, c, color[c]);
    }
  }
  return image;
}

Color4 LookUpPaint(vtkImageData* image, double u, double v)
{
  int size[3];
  image->GetDimensions(size);
  const double texel[2] = { std::min(std::max(u, 0.0), 1.0) * (size[0] - 1),
    std::min(std::max(v, 0.0), 1.0) * (size[1] - 1) };
  const int first[2] = { std::min(static_cast<int>(texel[0]), size[0] - 2),
    std::min(static_cast<int>(texel[1]), size[1] - 2) };
  Color4 sum{};
  for (int corner = 0; corner < 4; ++corner)
  {
    const int i = first[0] + corner % 2;
    const int j = first[1] + corner / 2;
    const double weight = (1.0 - std::abs(texel[0] - i)) * (1.0 - std::abs(texel[1] - j));
    const double alpha = image->GetScalarComponentAsDouble(i, j, 0, 3);
    for (int c = 0; c < 4; ++c)
    {
      sum[c] += weight * (c < 3 ? alpha * image->GetScalarComponentAsDouble(i, j, 0, c) : alpha);
    }
  }
  for (int c = 0; c < 3; ++c)
  {
    sum[c] /= std::max(sum[3], 1e-300);
  }
  return sum;
}

RgbaImage MakeFlowReferenceImage(const FlowScene& scene, int pieces)
{
  RgbaImage rendered(scene.Size[0], scene.Size[1]);
  const PixelRays rays(scene.Camera, scene.Size);
  vtkSMPTools::For(0, scene.Size[1],
    [&](vtkIdType first, vtkIdType last)
    {
      for (int j = static_cast<int>(first); j < last; ++j)
      {
        for (int i = 0; i < scene.Size[0]; ++i)
        {
          const Ray ray = rays.Get(i, j);
          double lower = 0.0;
          double upper = 1e30;
          for (int axis = 0; axis < 3; ++axis)
          {
            const double o = static_cast<double>(ray.Origin[axis]);
            const double d = static_cast<double>(ray.Direction[axis]);
            const double a = (-HALF - o) / d;
            const double b = (HALF - o) / d;
            lower = std::max(lower, std::min(a, b));
            upper = std::min(upper, std::max(a, b));
          }
          double* pixel = rendered.At(i, j);
          const double length = (upper - lower) / pieces;
          for (int k = 0; k < pieces && length > 0.0; ++k)
          {
            Position3 x;
            for (int axis = 0; axis < 3; ++axis)
            {
              x[axis] = static_cast<double>(ray.Origin[axis]) +
                (lower + (k + 0.5) * length) * static_cast<double>(ray.Direction[axis]);
            }
            const FlowEnd end = scene.Flow(x);
            if (!end.IsReached || (scene.IsRetained && !scene.IsRetained(x)))
            {
              continue;
            }
            const Color4 paint = scene.Paint(end);
            const double opacity = 1.0 - std::pow(1.0 - paint[3], length / scene.UnitDistance);
            const double transmittance = 1.0 - pixel[3];
            for (int c = 0; c < 4; ++c)
            {
              pixel[c] += transmittance * opacity * (c < 3 ? paint[c] : 1.0);
            }
          }
        }
      }
    });
  return rendered;
}

}
