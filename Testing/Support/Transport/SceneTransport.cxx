// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Transport/SceneTransport.h"

#include "Support/Images/ReferenceRay.h"
#include "Support/Transport/VolumeMedium.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <stdexcept>

namespace reference
{

namespace
{

TransportLight ToTransport(vtkLight* light)
{
  if (light->GetPositional() != 0)
  {
    throw std::invalid_argument("positional lights are not supported");
  }
  glm::dvec3 position;
  glm::dvec3 focus;
  light->GetTransformedPosition(glm::value_ptr(position));
  light->GetTransformedFocalPoint(glm::value_ptr(focus));
  return { glm::normalize(focus - position),
    light->GetIntensity() * glm::make_vec3(light->GetDiffuseColor()) };
}

}

TransportImage TraceScene(const ShadowScene& scene, const SceneTransportSettings& settings)
{
  if (scene.Matrix || !scene.Actors.empty())
  {
    throw std::invalid_argument("volume matrices and opaque actors are not supported");
  }
  const VolumeMedium medium(scene.Image, scene.Property, settings.Albedo);
  ImageTransportSettings traced;
  traced.Phase = settings.Phase;
  for (const auto& light : scene.Lights)
  {
    traced.Lights.push_back(ToTransport(light));
  }
  traced.MaximumScatterings = settings.MaximumScatterings;
  traced.PathsPerPixel = settings.PathsPerPixel;
  traced.Seed = settings.Seed;
  const PixelRays rays(scene.Camera, scene.Size);
  const auto lines = [&rays](int i, int j)
  {
    const Ray ray = rays.Get(i, j);
    const auto toVector = [](const Vector& v)
    {
      return glm::dvec3(
        static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2]));
    };
    return TransportRay{ toVector(ray.Origin), toVector(ray.Direction) };
  };
  return TraceImage(medium, scene.Size[0], scene.Size[1], lines, traced);
}

}
