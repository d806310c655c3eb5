// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAnalyticFieldSource.h"

#include "Analytic/ElementaryFields.h"
#include "Common/NamedValue.h"
#include "Common/Vectors.h"
#include "Sampling/ClampedValue.h"
#include "Vortices/VortexTubes.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkAnalyticFieldSource);

namespace
{
constexpr double Limit = 1e6;

// Returns base + rate * time.
glm::dvec3 Advance(const double base[3], const double rate[3], double time)
{
  return glm::make_vec3(base) + glm::make_vec3(rate) * time;
}
}

const char* vtkAnalyticFieldSource::GetFieldName(int field)
{
  static const char* const names[NUMBER_OF_FIELDS] = { "wave", "vortex", "linear", "ball",
    "gyroid" };
  return field >= 0 && field < NUMBER_OF_FIELDS ? names[field] : nullptr;
}

void vtkAnalyticFieldSource::SetVector(double (&member)[3], double x, double y, double z)
{
  interlume::ClampedValue::Set(this, member, { x, y, z }, -Limit, Limit);
}

void vtkAnalyticFieldSource::SetNumber(double& member, double value)
{
  interlume::ClampedValue::Set(this, member, value, -Limit, Limit);
}

vtkFieldSampler::Field vtkAnalyticFieldSource::GetFieldAtTime(double t) const
{
  switch (this->Field)
  {
    case WAVE:
      return interlume::ElementaryFields::Wave{ t };
    case LINEAR:
      return interlume::ElementaryFields::Linear{ t, this->Constant, glm::make_vec3(this->Gradient),
        this->Rate };
    case BALL:
      return interlume::ElementaryFields::Ball{ Advance(this->Center, this->Velocity, t),
        this->Radius + this->Growth * t };
    case GYROID:
      return interlume::ElementaryFields::Gyroid{ Advance(this->Center, this->Velocity, t) };
    default:
      return interlume::VortexTubes(t);
  }
}

void vtkAnalyticFieldSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  interlume::NamedValue::Print(os, indent,
    { { "Field", GetFieldName(this->Field) }, { "Constant", this->Constant },
      { "Gradient", this->Gradient }, { "Rate", this->Rate }, { "Center", this->Center },
      { "Velocity", this->Velocity }, { "Radius", this->Radius }, { "Growth", this->Growth } });
}
