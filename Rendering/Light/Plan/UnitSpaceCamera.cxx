// SPDX-License-Identifier: BSD-3-Clause
#include "Plan/UnitSpaceCamera.h"

#include "Space/UnitSpace.h"
#include "Space/UnitVector.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderer.h"

namespace interlume
{

SlicePlan::Eye UnitSpaceCamera::Get(vtkRenderer* renderer, const UnitSpace& space)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  const auto fromRows = [](vtkMatrix4x4* matrix)
  { return UnitVector::FromRows(matrix->GetData()); };
  SlicePlan::Eye eye;
  // Everything is put together in double precision before a coordinate is touched.
  eye.ClipFromUnit =
    fromRows(camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1.0, 1.0)) *
    (fromRows(camera->GetModelViewTransformMatrix()) * space.GetWorldFromUnit());
  const glm::dmat4 inverse = glm::inverse(eye.ClipFromUnit);

  eye.IsParallel = camera->GetParallelProjection() != 0;
  // The eye is where lines of sight meet, also where a stereo view shears them.
  const glm::dvec4 apex = inverse * glm::dvec4(0.0, 0.0, -1.0, 0.0);
  const glm::dvec4 near = inverse * glm::dvec4(0.0, 0.0, -1.0, 1.0);
  const glm::dvec4 far = inverse * glm::dvec4(0.0, 0.0, 1.0, 1.0);
  const glm::dvec3 forward = glm::dvec3(far) / far.w - glm::dvec3(near) / near.w;
  eye.Direction = forward / glm::length(forward);
  eye.Position =
    eye.IsParallel ? glm::dvec3(near) / near.w - 4.0 * eye.Direction : glm::dvec3(apex) / apex.w;
  return eye;
}

}
