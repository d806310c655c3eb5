// SPDX-License-Identifier: BSD-3-Clause
#include "Plan/UnitSpaceCamera.h"

#include "Space/UnitSpace.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

namespace interlume
{

namespace
{
using Matrix = std::array<double, 16>;

std::array<double, 4> Multiply(const Matrix& m, const std::array<double, 4>& v)
{
  std::array<double, 4> result{};
  vtkMatrix4x4::MultiplyPoint(m.data(), v.data(), result.data());
  return result;
}
}

SlicePlan::Eye UnitSpaceCamera::Get(vtkRenderer* renderer, const UnitSpace& space)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  vtkNew<vtkMatrix4x4> worldFromUnit;
  for (int i = 0; i < 3; ++i)
  {
    worldFromUnit->SetElement(i, i, space.Radius);
    worldFromUnit->SetElement(i, 3, space.Center[i]);
  }
  // Everything is put together in double precision before a coordinate is touched.
  vtkNew<vtkMatrix4x4> clip;
  vtkMatrix4x4::Multiply4x4(camera->GetModelViewTransformMatrix(), worldFromUnit, clip);
  vtkMatrix4x4::Multiply4x4(
    camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1.0, 1.0), clip, clip);
  SlicePlan::Eye eye;
  std::copy_n(clip->GetData(), 16, eye.ClipFromUnit.begin());
  Matrix inverse{};
  vtkMatrix4x4::Invert(eye.ClipFromUnit.data(), inverse.data());

  eye.IsParallel = camera->GetParallelProjection() != 0;
  // The eye is where lines of sight meet, also where a stereo view shears them.
  const std::array<double, 4> apex = Multiply(inverse, { { 0.0, 0.0, -1.0, 0.0 } });
  const std::array<double, 4> near = Multiply(inverse, { { 0.0, 0.0, -1.0, 1.0 } });
  const std::array<double, 4> far = Multiply(inverse, { { 0.0, 0.0, 1.0, 1.0 } });
  double length = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    eye.Direction[i] = far[i] / far[3] - near[i] / near[3];
    length += eye.Direction[i] * eye.Direction[i];
  }
  length = std::sqrt(length);
  for (int i = 0; i < 3; ++i)
  {
    eye.Direction[i] /= length;
    eye.Position[i] =
      eye.IsParallel ? near[i] / near[3] - 4.0 * eye.Direction[i] : apex[i] / apex[3];
  }
  return eye;
}

}
