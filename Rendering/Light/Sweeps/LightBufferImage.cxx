// SPDX-License-Identifier: BSD-3-Clause
#include "Sweeps/LightBufferImage.h"

#include "Common/Vectors.h"
#include "Sweeps/SliceRasterizer.h"
#include "Space/UnitSpace.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>

namespace interlume
{

bool LightBufferImage::Read(SliceRasterizer& rasterizer, const ImageState& state,
  const UnitSpace& space, vtkOpenGLRenderWindow* window, vtkLight* light, vtkImageData* image)
{
  for (const SlicePlan::Sweep& sweep : state.Plan.Sweeps)
  {
    for (const SlicePlan::ShadowedLight& shadowed : sweep.Lights)
    {
      if (state.Lights[shadowed.Light].Light != light)
      {
        continue;
      }
      int size = 0;
      int channels = 0;
      const std::vector<float> texels =
        rasterizer.ReadLightBuffer(window, shadowed.Light, size, channels);
      if (texels.empty())
      {
        return false;
      }
      image->Initialize();
      image->SetDimensions(size, size, 1);
      vtkNew<vtkFloatArray> values;
      values->SetName("Transmittance");
      values->SetNumberOfComponents(channels);
      values->SetNumberOfTuples(static_cast<vtkIdType>(size) * size);
      std::copy(texels.begin(), texels.end(), values->GetPointer(0));
      image->GetPointData()->SetScalars(values);

      // The matrix leads from clip coordinates to texture coordinates, after the way from world to
      // unit space.
      glm::dmat4 texture(glm::dmat3(0.5));
      texture[3] = glm::dvec4(0.5, 0.5, 0.5, 1.0);
      vtkNew<vtkDoubleArray> matrix;
      matrix->SetName("BufferFromWorld");
      matrix->SetNumberOfTuples(16);
      const glm::dmat4 rows =
        glm::transpose(texture * (shadowed.BufferFromUnit * space.GetUnitFromWorld()));
      std::copy_n(glm::value_ptr(rows), 16, matrix->GetPointer(0));
      image->GetFieldData()->AddArray(matrix);
      return true;
    }
  }
  return false;
}

}
