// SPDX-License-Identifier: BSD-3-Clause
// Light sources of a renderer in unit space, compared with VTK's transformed positions.
#include "Support/Checks/ReferenceCheck.h"

#include "vtkAreaLight.h"
#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "Lights/EmitterSamples.h"
#include "Lights/LightSources.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderer.h"
#include "vtkPointData.h"
#include "vtkProjectiveLight.h"
#include "Space/UnitSpace.h"
#include "Space/UnitVector.h"

#include <limits>

namespace
{

using namespace reference;
using namespace interlume::UnitVector;

constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();

// Returns the unit space of a cubic volume with edges of length 10, centered at (100, 0, 0).
interlume::UnitSpace MakeSpace()
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(11, 11, 11);
  image->SetOrigin(95.0, -5.0, -5.0);
  vtkNew<vtkMatrix4x4> matrix;
  interlume::UnitSpace space;
  static_cast<void>(space.Set(image, true, matrix));
  return space;
}

struct Scene
{
  vtkNew<vtkOpenGLRenderer> Renderer;
  interlume::UnitSpace Space = MakeSpace();
  interlume::LightSources::Settings Settings;
  std::vector<std::string> Errors;

  Scene()
  {
    vtkNew<vtkCamera> camera;
    camera->SetPosition(90.0, 20.0, 30.0);
    camera->SetFocalPoint(100.0, 1.0, 2.0);
    camera->SetViewUp(0.3, 1.0, 0.1);
    this->Renderer->SetActiveCamera(camera);
  }
  vtkLight* Add(int type, bool isPositional, vtkLight* light)
  {
    light->SetLightType(type);
    light->SetPositional(isPositional);
    light->SetPosition(103.0, 8.0, 9.0);
    light->SetFocalPoint(99.0, 2.0, 1.0);
    this->Renderer->AddLight(light);
    return light;
  }
  vtkLight* Add(int type, bool isPositional)
  {
    return this->Add(type, isPositional, vtkNew<vtkLight>());
  }
  std::vector<interlume::LightSource> Gather()
  {
    this->Errors.clear();
    return interlume::LightSources::Gather(
      this->Renderer, this->Space, this->Settings, this->Errors);
  }
};

void CheckVector(
  Check& check, const glm::dvec3& found, const glm::dvec3& expected, const std::string& what)
{
  check.Near(interlume::Vectors::SafeLength(found - expected), 0.0, 1e-12, what, 1.0);
}

// Checks positions before and after the renderer updates its camera lights. Lights that do not
// follow the camera remain unchanged.
void CheckPositions(Check& check)
{
  for (const int type :
    { VTK_LIGHT_TYPE_HEADLIGHT, VTK_LIGHT_TYPE_CAMERA_LIGHT, VTK_LIGHT_TYPE_SCENE_LIGHT })
  {
    for (const bool follows : { true, false })
    {
      for (const bool isPositional : { false, true })
      {
        check.SetContext("type " + std::to_string(type));
        Scene scene;
        scene.Renderer->SetLightFollowCamera(follows);
        vtkLight* light = scene.Add(type, isPositional);
        const vtkMTimeType time = light->GetMTime();
        const interlume::LightSource source = scene.Gather().at(0);
        check.That(light->GetMTime() == time, "the light is not modified");
        if (follows)
        {
          scene.Renderer->UpdateLightsGeometryToFollowCamera();
        }
        const interlume::LightSource after = scene.Gather().at(0);
        glm::dvec3 position;
        glm::dvec3 focalPoint;
        light->GetTransformedPosition(glm::value_ptr(position));
        light->GetTransformedFocalPoint(glm::value_ptr(focalPoint));
        const glm::dvec3 axis = focalPoint - position;
        const glm::dvec3 direction = Normalize(axis, axis);
        const glm::dvec3 unit =
          (1.0 / scene.Space.Radius) * (position - glm::dvec3(100.0, 0.0, 0.0));
        for (const interlume::LightSource& found : { source, after })
        {
          check.That(found.Light == light && !found.Projective, "the source refers to the light");
          check.That(found.IsPositional == isPositional, "positional");
          CheckVector(check, found.Position, unit, "position");
          CheckVector(check, found.Direction, direction, "direction");
        }
      }
    }
  }
}

void CheckValues(Check& check)
{
  check.SetContext("");
  Scene scene;
  vtkLight* light = scene.Add(VTK_LIGHT_TYPE_SCENE_LIGHT, true);
  light->SetIntensity(0.5);
  light->SetAmbientColor(0.1, 0.2, 0.3);
  light->SetDiffuseColor(0.4, 0.5, 0.6);
  light->SetSpecularColor(0.7, 0.8, 0.9);
  light->SetConeAngle(60.0);
  light->SetExponent(3.0);
  light->SetAttenuationValues(0.3, 0.04, 0.005);
  interlume::LightSource source = scene.Gather().at(0);
  CheckVector(check, source.Ambient, glm::dvec3(0.05, 0.1, 0.15), "ambient");
  CheckVector(check, source.Diffuse, glm::dvec3(0.2, 0.25, 0.3), "diffuse");
  CheckVector(check, source.Specular, glm::dvec3(0.35, 0.4, 0.45), "specular");
  check.Near(source.ConeCosine, 0.5, 1e-12, "cone");
  check.Near(source.Exponent, 3.0, 0.0, "exponent");
  // The attenuation at a point is the same in unit space as in world space.
  const double distance = 7.0;
  const double unit = distance / scene.Space.Radius;
  check.Near(
    source.Attenuation[0] + source.Attenuation[1] * unit + source.Attenuation[2] * unit * unit,
    0.3 + 0.04 * distance + 0.005 * distance * distance, 1e-12, "attenuation");
  check.Near(source.ShadowStrength, 1.0, 0.0, "shadows");

  light->SetConeAngle(90.0);
  source = scene.Gather().at(0);
  check.That(
    source.ConeCosine == -1.0 && source.Exponent == 0.0, "there is no cone from 90 degrees on");
  light->SetConeAngle(30.0);
  light->SetPositional(false);
  source = scene.Gather().at(0);
  check.That(source.ConeCosine == -1.0 && source.Attenuation == glm::dvec3(1.0, 0.0, 0.0),
    "a directional light has neither cone nor attenuation");
}

void CheckShadows(Check& check)
{
  Scene scene;
  // With the colors set below, the brightnesses are 0.5, 2, 1, 1 and 0.
  const double intensities[5] = { 0.5, 2.0, 1.0, 1.0, 3.0 };
  std::vector<vtkLight*> lights;
  for (const double intensity : intensities)
  {
    lights.push_back(scene.Add(VTK_LIGHT_TYPE_SCENE_LIGHT, false));
    lights.back()->SetIntensity(intensity);
  }
  lights[0]->SetDiffuseColor(0.2, 1.0, 0.0);
  lights[1]->SetShadowAttenuation(0.25f);
  lights[4]->SetDiffuseColor(0.0, 0.0, 0.0);
  lights[4]->SetSpecularColor(0.0, 0.0, 0.0);
  lights[4]->SetAmbientColor(1.0, 1.0, 1.0);
  const auto expectStrengths = [&](const std::vector<double>& expected, const std::string& what)
  {
    const std::vector<interlume::LightSource> sources = scene.Gather();
    check.Equal(static_cast<long long>(sources.size()), 5, what);
    for (std::size_t i = 0; i < sources.size(); ++i)
    {
      check.That(sources[i].Light == lights[i], "the order of the renderer");
      check.Near(sources[i].ShadowStrength, expected[i], 0.0, what);
    }
  };
  expectStrengths({ 1.0, 0.25, 1.0, 1.0, 0.0 }, "all lights except the black light");
  scene.Settings.MaximumNumberOfShadowLights = 2;
  expectStrengths(
    { 0.0, 0.25, 1.0, 0.0, 0.0 }, "the two brightest lights, the first of equal lights");
  scene.Settings.MaximumNumberOfShadowLights = 0;
  expectStrengths({ 0.0, 0.0, 0.0, 0.0, 0.0 }, "no shadow lights");
  scene.Settings.MaximumNumberOfShadowLights = 3;
  lights[1]->SetShadowAttenuation(0.0f);
  expectStrengths({ 1.0, 0.0, 1.0, 1.0, 0.0 }, "a light without shadows does not count");
  lights[1]->SetShadowAttenuation(4.0f);
  expectStrengths({ 0.0, 1.0, 1.0, 1.0, 0.0 }, "clamped");
  lights[1]->SetShadowAttenuation(-4.0f);
  lights[2]->SetShadowAttenuation(std::numeric_limits<float>::quiet_NaN());
  expectStrengths({ 1.0, 0.0, 0.0, 1.0, 0.0 }, "negative and NaN values are 0");
  scene.Settings.Shadows = false;
  expectStrengths({ 0.0, 0.0, 0.0, 0.0, 0.0 }, "shadows off");

  lights[4]->SetAmbientColor(0.0, 0.0, 0.0);
  lights[3]->SetIntensity(0.0);
  lights[2]->SetSwitch(false);
  check.Equal(
    static_cast<long long>(scene.Gather().size()), 2, "lights that are off or black are skipped");
  check.That(scene.Errors.empty(), "skipped lights are not errors");
}

void CheckProjective(Check& check)
{
  for (const int type :
    { VTK_LIGHT_TYPE_HEADLIGHT, VTK_LIGHT_TYPE_CAMERA_LIGHT, VTK_LIGHT_TYPE_SCENE_LIGHT })
  {
    Scene scene;
    vtkNew<vtkProjectiveLight> light;
    light->SetScreenSize(3.0, 2.0);
    scene.Add(type, true, light);
    const interlume::LightSource source = scene.Gather().at(0);
    check.That(source.Projective == light, "a projective light");
    scene.Renderer->UpdateLightsGeometryToFollowCamera();
    vtkNew<vtkMatrix4x4> world;
    light->GetScreenMatrix(world);
    for (const glm::dvec3& point : { glm::dvec3(101.0, 1.0, 2.0), glm::dvec3(96.0, -3.0, 4.0) })
    {
      const glm::dvec3 unit = scene.Space.ToUnit(glm::value_ptr(point));
      const double from[4] = { point[0], point[1], point[2], 1.0 };
      glm::dvec4 to[2];
      world->MultiplyPoint(from, glm::value_ptr(to[0]));
      to[1] = source.ScreenFromUnit * glm::dvec4(unit, 1.0);
      for (int i = 0; i < 2; ++i)
      {
        check.Near(to[1][i] / to[1][3], to[0][i] / to[0][3], 1e-11, "position on the screen", 1.0);
      }
      check.That((to[0][3] > 0.0) == (to[1][3] > 0.0), "in front or behind");
    }
  }
}

// Compares emitter samples computed in unit space with the samples of the vtkAreaLight in world
// space. An area light of size 0 is treated as a vtkLight.
void CheckArea(Check& check)
{
  for (const int type :
    { VTK_LIGHT_TYPE_HEADLIGHT, VTK_LIGHT_TYPE_CAMERA_LIGHT, VTK_LIGHT_TYPE_SCENE_LIGHT })
  {
    for (const bool isPositional : { false, true })
    {
      Scene scene;
      vtkNew<vtkAreaLight> light;
      light->SetSize(3.0, 2.0);
      light->SetViewUp(0.2, 1.0, 0.0);
      scene.Add(type, isPositional, light);
      const interlume::LightSource source = scene.Gather().at(0);
      check.That(source.Area == light, "an area light");
      scene.Renderer->UpdateLightsGeometryToFollowCamera();
      double focalPoint[3];
      light->GetTransformedFocalPoint(focalPoint);
      const std::vector<vtkAreaLight::Sample> world = light->GetSamples(5);
      const auto samples = interlume::EmitterSamples::Make(true, nullptr, 5);
      for (std::size_t i = 0; i < samples.size(); ++i)
      {
        const interlume::LightSource sample =
          interlume::EmitterSamples::MakeSource(source, samples[i]);
        if (isPositional)
        {
          CheckVector(
            check, sample.Position, scene.Space.ToUnit(world[i].Position), "position of a sample");
        }
        else
        {
          const glm::dvec3 axis = glm::make_vec3(focalPoint) - glm::make_vec3(world[i].Position);
          CheckVector(check, sample.Direction, Normalize(axis, {}), "direction of a sample");
        }
      }
    }
  }

  Scene scene;
  vtkNew<vtkAreaLight> light;
  scene.Add(VTK_LIGHT_TYPE_SCENE_LIGHT, true, light);
  light->SetSize(0.0, 0.0);
  check.That(!scene.Gather().at(0).Area, "a light of size 0 has no extent");
  light->SetSize(0.0, 1.0);
  check.That(scene.Gather().at(0).Area == light, "a line has an extent");
  vtkNew<vtkImageData> image;
  image->SetDimensions(1, 1, 1);
  image->AllocateScalars(VTK_DOUBLE, 3);
  for (int k = 0; k < 3; ++k)
  {
    image->SetScalarComponentFromDouble(0, 0, 0, k, 0.2 * (k + 1));
  }
  light->SetEmitter(image);
  light->SetIntensity(3.0);
  for (const double size : { 0.0, 1.0 })
  {
    light->SetSize(size, size);
    CheckVector(
      check, 0.1 * scene.Gather().at(0).Diffuse, { 0.1, 0.2, 0.3 }, "the emitter's color");
  }
  image->GetPointData()->GetScalars()->Fill(0.0);
  image->GetPointData()->GetScalars()->Modified();
  light->SetAmbientColor(0.0, 0.0, 0.0);
  check.That(scene.Gather().empty() && scene.Errors.empty(), "a black emitter emits no light");
}

void CheckErrors(Check& check)
{
  Scene scene;
  const auto expectError = [&](vtkLight* light, const std::string& what)
  {
    check.That(scene.Gather().empty(), what + " is skipped");
    check.That(scene.Errors.size() == 1 && scene.Errors[0].find("Light 0") != std::string::npos,
      what + " is an error");
    scene.Renderer->RemoveLight(light);
  };
  const auto add = [&](bool isPositional)
  { return scene.Add(VTK_LIGHT_TYPE_SCENE_LIGHT, isPositional); };
  vtkLight* light = add(false);
  light->SetFocalPoint(light->GetPosition());
  expectError(light, "a light without direction");
  light = add(true);
  light->SetFocalPoint(light->GetPosition());
  light->SetConeAngle(30.0);
  expectError(light, "a cone without direction");
  light = add(true);
  light->SetFocalPoint(light->GetPosition());
  light->SetConeAngle(180.0);
  check.That(
    scene.Gather().size() == 1 && scene.Errors.empty(), "a point light needs no direction");
  light->SetPosition(NotANumber, 0.0, 0.0);
  expectError(light, "a position of NaN");
  light = add(true);
  light->SetFocalPoint(0.0, std::numeric_limits<double>::infinity(), 0.0);
  expectError(light, "an infinite focal point");
  light = add(true);
  light->SetIntensity(NotANumber);
  expectError(light, "an intensity of NaN");
  light = add(true);
  light->SetConeAngle(NotANumber);
  expectError(light, "a cone of NaN");
  light = add(true);
  light->SetAttenuationValues(1.0, NotANumber, 0.0);
  expectError(light, "an attenuation of NaN");
  vtkNew<vtkProjectiveLight> projective;
  projective->SetImage(vtkNew<vtkImageData>());
  expectError(scene.Add(VTK_LIGHT_TYPE_SCENE_LIGHT, true, projective), "an image without samples");
  vtkNew<vtkAreaLight> area;
  area->SetEmitter(vtkNew<vtkImageData>());
  expectError(scene.Add(VTK_LIGHT_TYPE_SCENE_LIGHT, true, area), "an emitter without samples");
  area->SetEmitter(nullptr);
  scene.Add(VTK_LIGHT_TYPE_SCENE_LIGHT, true, area);
  area->SetFocalPoint(area->GetPosition());
  expectError(area, "an emitter without direction");
  scene.Add(VTK_LIGHT_TYPE_SCENE_LIGHT, false, area);
  area->SetPosition(103.0, 8.0, 9.0);
  area->SetFocalPoint(103.0, 8.0, std::nextafter(9.0, 10.0));
  area->SetSize(1e30, 1e30);
  check.That(scene.Gather().size() == 1 && scene.Errors.empty(), "a huge emitter is valid");
}
}

int TestLightSources(int, char*[])
{
  Check check;
  CheckPositions(check);
  CheckValues(check);
  CheckShadows(check);
  CheckProjective(check);
  CheckArea(check);
  CheckErrors(check);
  return check.Result();
}
