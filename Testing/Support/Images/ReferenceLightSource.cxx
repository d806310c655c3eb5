// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Images/ReferenceLightSource.h"

#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkProjectiveLight.h"

#include <stdexcept>

namespace reference
{

namespace
{

Double3 Times(const double color[3], double factor)
{
  return { { factor * color[0], factor * color[1], factor * color[2] } };
}

}

ReferenceLightSource::ReferenceLightSource(vtkLight* light, const std::vector<LightPoint>& points)
  : IsPositional(light->GetPositional() != 0)
  , Ambient(Times(light->GetAmbientColor(), light->GetIntensity()))
  , Diffuse(Times(light->GetDiffuseColor(), light->GetIntensity()))
  , Specular(Times(light->GetSpecularColor(), light->GetIntensity()))
  , ShadowStrength(light->GetShadowAttenuation())
  , Points(points)
  , Projective(vtkProjectiveLight::SafeDownCast(light))
{
  light->GetTransformedPosition(this->Position.data());
  double focus[3];
  light->GetTransformedFocalPoint(focus);
  vtkMath::Subtract(focus, this->Position.data(), this->Direction.data());
  vtkMath::Normalize(this->Direction.data());
  if (this->IsPositional)
  {
    this->ConeCosine = light->GetConeAngle() < 90.0
      ? std::cos(vtkMath::RadiansFromDegrees(light->GetConeAngle()))
      : -1.0;
    this->Exponent = this->ConeCosine > -1.0 ? light->GetExponent() : 0.0;
    light->GetAttenuationValues(this->FallOff.data());
  }
  if (this->Projective)
  {
    vtkNew<vtkMatrix4x4> matrix;
    if (!this->Projective->GetScreenMatrix(matrix))
    {
      throw std::invalid_argument("the projective light has no direction");
    }
    std::copy(matrix->GetData(), matrix->GetData() + 16, this->ScreenFromWorld.begin());
  }
}

ReferenceLightSource::Arrival ReferenceLightSource::At(const Double3& world) const
{
  Arrival arrival;
  if (this->IsPositional)
  {
    vtkMath::Subtract(this->Position.data(), world.data(), arrival.ToLight.data());
    arrival.Distance = vtkMath::Normalize(arrival.ToLight.data());
  }
  else
  {
    arrival.ToLight = Times(this->Direction.data(), -1.0);
    arrival.Distance = std::numeric_limits<double>::infinity();
  }
  const Double3 fraction = this->GetReceivedFraction(world, arrival);
  for (int k = 0; k < 3; ++k)
  {
    arrival.Diffuse[k] = fraction[k] * this->Diffuse[k];
    arrival.Specular[k] = fraction[k] * this->Specular[k];
  }
  return arrival;
}

std::vector<ReferenceLightSource::ShadowRay> ReferenceLightSource::GetShadowRays(
  const Double3& world, const Arrival& arrival) const
{
  if (this->Points.empty())
  {
    return { { arrival.ToLight, arrival.Distance } };
  }
  std::vector<ShadowRay> rays;
  for (const LightPoint& point : this->Points)
  {
    ShadowRay ray;
    ray.ToLight = point.Position;
    if (this->IsPositional)
    {
      vtkMath::Subtract(point.Position.data(), world.data(), ray.ToLight.data());
    }
    const double length = vtkMath::Normalize(ray.ToLight.data());
    ray.Distance = this->IsPositional ? length : arrival.Distance;
    ray.Fraction = Times(point.Color.data(), 1.0 / static_cast<double>(this->Points.size()));
    rays.push_back(ray);
  }
  return rays;
}

Double3 ReferenceLightSource::GetReceivedFraction(
  const Double3& world, const Arrival& arrival) const
{
  double fraction = 1.0;
  if (this->IsPositional)
  {
    const double d = arrival.Distance;
    const double cosine = -vtkMath::Dot(this->Direction.data(), arrival.ToLight.data());
    fraction = 1.0 / (this->FallOff[0] + d * (this->FallOff[1] + d * this->FallOff[2]));
    if (this->ConeCosine > -1.0)
    {
      fraction = cosine >= this->ConeCosine ? fraction * std::pow(cosine, this->Exponent) : 0.0;
    }
  }
  Double3 color = { { fraction, fraction, fraction } };
  if (this->Projective)
  {
    const double point[4] = { world[0], world[1], world[2], 1.0 };
    double screen[4];
    vtkMatrix4x4::MultiplyPoint(this->ScreenFromWorld.data(), point, screen);
    double seen[3] = { 0.0, 0.0, 0.0 };
    if (screen[3] > 0.0)
    {
      this->Projective->GetScreenColor(screen[0] / screen[3], screen[1] / screen[3], seen);
    }
    for (int k = 0; k < 3; ++k)
    {
      color[k] *= seen[k];
    }
  }
  return color;
}

}
