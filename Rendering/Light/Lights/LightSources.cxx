// SPDX-License-Identifier: BSD-3-Clause
#include "Lights/LightSources.h"

#include "Lights/EmitterSamples.h"
#include "Lights/LightFrame.h"
#include "Space/UnitSpace.h"
#include "Space/UnitVector.h"

#include "vtkAreaLight.h"
#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkProjectiveLight.h"
#include "vtkRenderer.h"

namespace interlume
{

namespace
{

using namespace UnitVector;

// Position and focal point of a light in world coordinates.
struct Placement
{
  double Position[3];
  double FocalPoint[3];
  /// Transform from light coordinates to world coordinates, or null if they are identical.
  vtkMatrix4x4* Transform = nullptr;
};

void TransformPoint(vtkMatrix4x4* transform, const double point[3], double result[3])
{
  const double from[4] = { point[0], point[1], point[2], 1.0 };
  double to[4];
  transform->MultiplyPoint(from, to);
  std::copy_n(to, 3, result);
}

// Returns the placement that vtkRenderer::UpdateLightsGeometryToFollowCamera would compute, without
// changing the light.
Placement FindPlacement(vtkLight* light, vtkRenderer* renderer)
{
  vtkCamera* camera = renderer->GetLightFollowCamera() && renderer->IsActiveCameraCreated()
    ? renderer->GetActiveCamera()
    : nullptr;
  Placement placement;
  placement.Transform = light->GetTransformMatrix();
  light->GetPosition(placement.Position);
  light->GetFocalPoint(placement.FocalPoint);
  if (camera && light->LightTypeIsHeadlight())
  {
    camera->GetPosition(placement.Position);
    camera->GetFocalPoint(placement.FocalPoint);
    placement.Transform = nullptr;
  }
  else if (camera && light->LightTypeIsCameraLight())
  {
    placement.Transform = camera->GetCameraLightTransformMatrix();
  }
  if (placement.Transform)
  {
    TransformPoint(placement.Transform, placement.Position, placement.Position);
    TransformPoint(placement.Transform, placement.FocalPoint, placement.FocalPoint);
  }
  return placement;
}

bool IsBlack(const glm::dvec3& color)
{
  return color == glm::dvec3(0.0);
}

glm::dvec3 GetColor(const double* color, double intensity)
{
  return glm::make_vec3(color) * intensity;
}

double GetBrightness(const LightSource& source)
{
  return std::max({ source.Diffuse.r, source.Diffuse.g, source.Diffuse.b });
}

// Returns the view-up vector in world coordinates.
glm::dvec3 GetViewUp(const double viewUp[3], const Placement& placement)
{
  double to[4] = { viewUp[0], viewUp[1], viewUp[2], 0.0 };
  if (placement.Transform)
  {
    placement.Transform->MultiplyPoint(to, to);
  }
  return glm::make_vec3(to);
}

// Sets EmitterAxes of an area light whose emitter has an extent. Returns an error if they are not
// finite.
Error SetEmitter(LightSource& source, const Placement& placement, const UnitSpace& space)
{
  const glm::dvec3 viewUp = GetViewUp(source.Area->GetViewUp(), placement);
  LightFrame frame;
  frame.Set(placement.Position, placement.FocalPoint, glm::value_ptr(viewUp));
  const double unit = source.IsPositional ? space.Radius : frame.Distance;
  const double* size = source.Area->GetSize();
  source.EmitterAxes = { (size[0] / unit) * frame.Right, (size[1] / unit) * frame.Up };
  if (!Vectors::IsFinite(source.EmitterAxes[0]) || !Vectors::IsFinite(source.EmitterAxes[1]))
  {
    return "its size or view-up vector is not finite";
  }
  return {};
}

// Multiplies the diffuse and specular colors by the color of the emitter's image. Returns an error
// if the image cannot be read.
Error SetEmitterColor(LightSource& source, const vtkAreaLight* light)
{
  glm::dvec3 color;
  light->GetEmitterColor(glm::value_ptr(color));
  source.Diffuse *= color;
  source.Specular *= color;
  return light->GetEmitterError();
}

// Sets ScreenFromUnit of a projective light. Returns an error if the matrix is not finite or the
// image is invalid.
Error SetScreen(LightSource& source, const Placement& placement, const glm::dvec3& focalPoint,
  const UnitSpace& space)
{
  const glm::dvec3 viewUp = GetViewUp(source.Projective->GetViewUp(), placement);
  vtkNew<vtkMatrix4x4> matrix;
  if (!source.Projective->GetScreenMatrix(glm::value_ptr(source.Position),
        glm::value_ptr(focalPoint), glm::value_ptr(viewUp), 1.0 / space.Radius, matrix))
  {
    return "its screen matrix is not finite";
  }
  source.ScreenFromUnit = UnitVector::FromRows(matrix->GetData());
  return source.Projective->GetImageError();
}

// Sets all members of \a source except ShadowStrength. Returns an error if the light is invalid.
Error SetSource(LightSource& source, vtkLight* light, vtkRenderer* renderer, const UnitSpace& space)
{
  source.Light = light;
  source.Projective = vtkProjectiveLight::SafeDownCast(light);
  auto* area = vtkAreaLight::SafeDownCast(light);
  const bool hasExtent = area && (area->GetSize()[0] > 0.0 || area->GetSize()[1] > 0.0);
  source.Area = hasExtent ? area : nullptr;
  source.IsPositional = light->GetPositional() != 0;
  source.Ambient = GetColor(light->GetAmbientColor(), light->GetIntensity());
  source.Diffuse = GetColor(light->GetDiffuseColor(), light->GetIntensity());
  source.Specular = GetColor(light->GetSpecularColor(), light->GetIntensity());
  if (!Vectors::IsFinite(source.Ambient) || !Vectors::IsFinite(source.Diffuse) ||
    !Vectors::IsFinite(source.Specular))
  {
    return "its color or intensity is not finite";
  }

  const Placement placement = FindPlacement(light, renderer);
  source.Position = space.ToUnit(placement.Position);
  const glm::dvec3 focalPoint = space.ToUnit(placement.FocalPoint);
  // Compute the axis in world coordinates, to avoid the rounding errors of the transformation to
  // unit space.
  const glm::dvec3 axis = glm::make_vec3(placement.FocalPoint) - glm::make_vec3(placement.Position);
  if (!Vectors::IsFinite(source.Position) || !Vectors::IsFinite(axis) ||
    !std::isfinite(Vectors::SafeLength(axis)))
  {
    return "its position or focal point is not finite";
  }
  const double angle = light->GetConeAngle();
  const bool hasCone = source.IsPositional && angle < 90.0;
  if (IsBlack(axis) && (!source.IsPositional || hasCone || source.Projective || hasExtent))
  {
    return "its position and focal point are the same";
  }
  source.Direction = Normalize(axis, source.Direction);

  if (!std::isfinite(angle) || !std::isfinite(light->GetExponent()))
  {
    return "its cone angle or exponent is not finite";
  }
  if (hasCone)
  {
    source.ConeCosine = std::cos(vtkMath::RadiansFromDegrees(std::max(angle, 0.0)));
    source.Exponent = light->GetExponent();
  }
  if (source.IsPositional)
  {
    const double* world = light->GetAttenuationValues();
    const glm::dvec3 attenuation{ world[0], world[1] * space.Radius,
      world[2] * space.Radius * space.Radius };
    if (!Vectors::IsFinite(attenuation))
    {
      return "its attenuation is not finite";
    }
    source.Attenuation = attenuation;
  }
  if (source.Projective)
  {
    return SetScreen(source, placement, focalPoint, space);
  }
  Error error = area ? SetEmitterColor(source, area) : Error();
  return error || !hasExtent ? error : SetEmitter(source, placement, space);
}

}

std::vector<LightSource> LightSources::Gather(vtkRenderer* renderer, const UnitSpace& space,
  const Settings& settings, std::vector<std::string>& warnings, std::vector<vtkLight*>* skipped)
{
  std::vector<LightSource> sources;
  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator iterator;
  lights->InitTraversal(iterator);
  for (int index = 0; vtkLight* light = lights->GetNextLight(iterator); ++index)
  {
    if (!light->GetSwitch())
    {
      continue;
    }
    LightSource source;
    if (const Error error = SetSource(source, light, renderer, space))
    {
      warnings.push_back(
        "Light " + std::to_string(index) + " is skipped: " + error.GetMessage() + ".");
      if (skipped)
      {
        skipped->push_back(light);
      }
      continue;
    }
    const bool shines = !IsBlack(source.Diffuse) || !IsBlack(source.Specular);
    if (!shines && IsBlack(source.Ambient))
    {
      continue;
    }
    if (settings.Shadows && shines)
    {
      const double strength = light->GetShadowAttenuation();
      source.ShadowStrength = strength > 0.0 ? std::min(strength, 1.0) : 0.0;
    }
    sources.push_back(source);
  }

  std::vector<std::size_t> shadowed;
  for (std::size_t i = 0; i < sources.size(); ++i)
  {
    if (sources[i].ShadowStrength > 0.0)
    {
      shadowed.push_back(i);
    }
  }
  std::stable_sort(shadowed.begin(), shadowed.end(),
    [&](std::size_t a, std::size_t b)
    { return GetBrightness(sources[a]) > GetBrightness(sources[b]); });
  const auto maximum = static_cast<std::size_t>(std::max(settings.MaximumNumberOfShadowLights, 0));
  for (std::size_t i = maximum; i < shadowed.size(); ++i)
  {
    sources[shadowed[i]].ShadowStrength = 0.0;
  }
  return sources;
}

}
