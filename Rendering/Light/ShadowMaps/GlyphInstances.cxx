// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowMaps/GlyphInstances.h"

#include "Common/Vectors.h"

#include "vtkBitArray.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkGlyph3DMapper.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkPointData.h"

#include <algorithm>
#include <array>

#include <glm/gtc/quaternion.hpp>

namespace interlume
{

namespace
{
// VTK replaces scale factors of 0 with this value.
constexpr double MinimumScale = 1e-10;

// Returns the array that the mapper selects by name or by point attribute, or null.
vtkDataArray* GetArray(vtkGlyph3DMapper* mapper, int which, vtkDataSet* points)
{
  vtkInformation* choice = mapper->GetInputArrayInformation(which);
  vtkPointData* data = points->GetPointData();
  if (const char* name = choice->Get(vtkDataObject::FIELD_NAME()))
  {
    return data->GetArray(name);
  }
  return choice->Has(vtkDataObject::FIELD_ATTRIBUTE_TYPE())
    ? data->GetAttribute(choice->Get(vtkDataObject::FIELD_ATTRIBUTE_TYPE()))
    : nullptr;
}

std::vector<double> GetTuple(vtkDataArray* array, vtkIdType point)
{
  std::vector<double> tuple(static_cast<std::size_t>(array->GetNumberOfComponents()));
  array->GetTuple(point, tuple.data());
  return tuple;
}

double GetNorm(const std::vector<double>& tuple)
{
  return vtkMath::Norm(tuple.data(), static_cast<int>(tuple.size()));
}

class GlyphArrays
{
public:
  GlyphArrays(vtkGlyph3DMapper* mapper, vtkDataSet* points)
    : Mapper(mapper)
    , Scales(GetArray(mapper, vtkGlyph3DMapper::SCALE, points))
    , Orientations(
        mapper->GetOrient() ? GetArray(mapper, vtkGlyph3DMapper::ORIENTATION, points) : nullptr)
    , Sources(mapper->GetSourceIndexing() ? GetArray(mapper, vtkGlyph3DMapper::SOURCE_INDEX, points)
                                          : nullptr)
    , Mask(mapper->GetMasking()
          ? vtkArrayDownCast<vtkBitArray>(GetArray(mapper, vtkGlyph3DMapper::MASK, points))
          : nullptr)
    , Lower(mapper->GetRange()[0])
    , Upper(mapper->GetRange()[1])
    , Width(Upper == Lower ? 1.0 : Upper - Lower)
  {
    if (mapper->GetScaleMode() == vtkGlyph3DMapper::NO_DATA_SCALING || !mapper->GetScaling())
    {
      this->Scales = nullptr;
    }
  }

  bool IsShown(vtkIdType point) const
  {
    const int components =
      this->Mapper->GetOrientationMode() == vtkGlyph3DMapper::QUATERNION ? 4 : 3;
    return (!this->Mask || this->Mask->GetValue(point) != 0) &&
      (!this->Orientations || this->Orientations->GetNumberOfComponents() == components);
  }

  int GetSource(vtkIdType point) const
  {
    const int last = std::max(this->Mapper->GetNumberOfInputConnections(1) - 1, 0);
    if (!this->Sources)
    {
      return 0;
    }
    const double value = GetNorm(GetTuple(this->Sources, point));
    return static_cast<int>(
      std::clamp((value - this->Lower) * (last + 1) / this->Width, 0.0, double(last)));
  }

  glm::dvec3 GetScale(vtkIdType point) const
  {
    if (!this->Mapper->GetScaling())
    {
      return glm::dvec3(1.0);
    }
    glm::dvec3 scale(1.0);
    if (this->Scales)
    {
      const std::vector<double> tuple = GetTuple(this->Scales, point);
      if (this->Mapper->GetScaleMode() == vtkGlyph3DMapper::SCALE_BY_MAGNITUDE)
      {
        scale = glm::dvec3(GetNorm(tuple));
      }
      else if (tuple.size() == 3)
      {
        scale = glm::make_vec3(tuple.data());
      }
      if (this->Mapper->GetClamping())
      {
        scale = (glm::clamp(scale, this->Lower, this->Upper) - this->Lower) / this->Width;
      }
    }
    scale *= this->Mapper->GetScaleFactor();
    for (int axis = 0; axis < 3; ++axis)
    {
      scale[axis] = scale[axis] == 0.0 ? MinimumScale : scale[axis];
    }
    return scale;
  }

  glm::dmat3 GetRotation(vtkIdType point) const
  {
    if (!this->Orientations)
    {
      return glm::dmat3(1.0);
    }
    const std::vector<double> tuple = GetTuple(this->Orientations, point);
    if (this->Mapper->GetOrientationMode() == vtkGlyph3DMapper::QUATERNION)
    {
      return glm::mat3_cast(glm::normalize(glm::dquat(tuple[0], tuple[1], tuple[2], tuple[3])));
    }
    if (this->Mapper->GetOrientationMode() == vtkGlyph3DMapper::ROTATION)
    {
      const auto about = [&](int axis)
      {
        glm::dvec3 direction(0.0);
        direction[axis] = 1.0;
        return glm::mat3_cast(glm::angleAxis(
          vtkMath::RadiansFromDegrees(tuple[static_cast<std::size_t>(axis)]), direction));
      };
      return about(2) * about(0) * about(1);
    }
    // Map the x axis to the direction by a half turn about their bisector.
    const glm::dvec3 direction = glm::make_vec3(tuple.data());
    if (direction.y == 0.0 && direction.z == 0.0)
    {
      return direction.x < 0.0
        ? glm::dmat3({ -1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, -1.0 })
        : glm::dmat3(1.0);
    }
    const glm::dvec3 bisector =
      glm::normalize(glm::dvec3(direction.x + glm::length(direction), direction.y, direction.z));
    return 2.0 * glm::outerProduct(bisector, bisector) - glm::dmat3(1.0);
  }

private:
  vtkGlyph3DMapper* Mapper;
  vtkDataArray* Scales;
  vtkDataArray* Orientations;
  vtkDataArray* Sources;
  vtkBitArray* Mask;
  double Lower;
  double Upper;
  double Width;
};
}

std::vector<GlyphInstances::Instance> GlyphInstances::Get(
  vtkGlyph3DMapper* mapper, vtkDataSet* points)
{
  const GlyphArrays arrays(mapper, points);
  std::vector<Instance> found;
  for (vtkIdType point = 0; point < points->GetNumberOfPoints(); ++point)
  {
    if (!arrays.IsShown(point))
    {
      continue;
    }
    glm::dvec3 origin;
    points->GetPoint(point, glm::value_ptr(origin));
    const glm::dmat3 rotation = arrays.GetRotation(point);
    const glm::dvec3 scale = arrays.GetScale(point);
    glm::dmat4 matrix(1.0);
    for (int axis = 0; axis < 3; ++axis)
    {
      matrix[axis] = glm::dvec4(scale[axis] * rotation[axis], 0.0);
    }
    matrix[3] = glm::dvec4(origin, 1.0);
    found.push_back({ arrays.GetSource(point), matrix });
  }
  return found;
}

}
