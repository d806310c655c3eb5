// SPDX-License-Identifier: BSD-3-Clause
#include "vtkConstructiveModelSource.h"

#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkSpatialOperation.h"
#include "vtkSpatialPrimitive.h"
#include "vtkSpatialTurbulence.h"
#include "vtkTransform.h"

#include <algorithm>

#include <glm/gtc/type_ptr.hpp>
#include <glm/vec3.hpp>

vtkStandardNewMacro(vtkConstructiveModelSource);

namespace
{
constexpr int MinimumResolution = 2;
constexpr int MaximumResolution = 2048;

using Object = vtkSmartPointer<vtkSpatialObject>;
using Primitive = vtkSmartPointer<vtkSpatialPrimitive>;

const glm::dvec3 Blue{ 0.27, 0.45, 0.68 };
const glm::dvec3 Orange{ 0.90, 0.58, 0.22 };
const glm::dvec3 Plaster{ 0.86, 0.84, 0.80 };
const glm::dvec3 Wood{ 0.60, 0.42, 0.27 };
const glm::dvec3 Fur{ 0.72, 0.50, 0.28 };
const glm::dvec3 PaleFur{ 0.90, 0.76, 0.55 };
const glm::dvec3 Black{ 0.08, 0.06, 0.05 };

Primitive MakePrimitive(int shape, const glm::dvec3& center, const glm::dvec3& color)
{
  auto primitive = Primitive::New();
  primitive->SetShape(shape);
  primitive->SetCenter(center[0], center[1], center[2]);
  primitive->SetColor(color[0], color[1], color[2]);
  return primitive;
}

Primitive MakeSphere(const glm::dvec3& center, double radius, const glm::dvec3& color)
{
  Primitive sphere = MakePrimitive(vtkSpatialPrimitive::SPHERE, center, color);
  sphere->SetRadius(radius);
  return sphere;
}

// Returns a box with the given lower and upper corners.
Primitive MakeBox(const glm::dvec3& lower, const glm::dvec3& upper, const glm::dvec3& color)
{
  Primitive box = MakePrimitive(vtkSpatialPrimitive::BOX, 0.5 * (lower + upper), color);
  box->SetLengths(upper[0] - lower[0], upper[1] - lower[1], upper[2] - lower[2]);
  return box;
}

// Returns an ellipsoid with the given semi-axes. The edge width is relative to the semi-axes.
Primitive MakeEllipsoid(
  const glm::dvec3& center, const glm::dvec3& halfAxes, double edge, const glm::dvec3& color)
{
  Primitive sphere = MakeSphere({ 0.0, 0.0, 0.0 }, 1.0, color);
  sphere->SetEdgeWidth(edge);
  vtkNew<vtkTransform> transform;
  transform->Translate(glm::value_ptr(center));
  transform->Scale(glm::value_ptr(halfAxes));
  sphere->SetTransform(transform);
  return sphere;
}

// Adds four legs that stand on the floor, at the corners of a rectangle around the z axis.
void AddLegs(vtkSpatialOperation* parts, double halfX, double halfY, double width, double height)
{
  for (double x : { -halfX, halfX - width })
  {
    for (double y : { -halfY, halfY - width })
    {
      parts->AddOperand(MakeBox({ x, y, 0.0 }, { x + width, y + width, height }, Wood));
    }
  }
}

Object MakeFuzzySphere()
{
  Primitive sphere = MakePrimitive(vtkSpatialPrimitive::FUZZY_SPHERE, { 0.0, 0.0, 0.0 }, Blue);
  sphere->SetRadius(0.5);
  sphere->SetInnerRadius(0.2);
  return sphere;
}

Object MakeRobot()
{
  auto robot = vtkSmartPointer<vtkSpatialOperation>::New();
  robot->AddOperand(MakeBox({ -0.14, -0.14, 0.95 }, { 0.14, 0.14, 1.23 }, Orange));
  robot->AddOperand(MakeBox({ -0.25, -0.25, 0.45 }, { 0.25, 0.25, 0.95 }, Blue));
  robot->AddOperand(MakeBox({ -0.22, -0.1, 0.0 }, { -0.06, 0.1, 0.45 }, Orange));
  robot->AddOperand(MakeBox({ 0.06, -0.1, 0.0 }, { 0.22, 0.1, 0.45 }, Orange));
  return robot;
}

Object MakeRings()
{
  constexpr int number = 6;
  constexpr double radius = 0.65;
  auto rings = vtkSmartPointer<vtkSpatialOperation>::New();
  Primitive large =
    MakePrimitive(vtkSpatialPrimitive::TORUS, { 0.0, 0.0, 0.0 }, { 0.80, 0.78, 0.74 });
  large->SetRadius(radius);
  large->SetTubeRadius(0.06);
  rings->AddOperand(large);
  for (int i = 0; i < number; ++i)
  {
    Primitive small =
      MakePrimitive(vtkSpatialPrimitive::TORUS, { 0.0, 0.0, 0.0 }, i % 2 == 0 ? Blue : Orange);
    small->SetRadius(0.26);
    small->SetTubeRadius(0.05);
    vtkNew<vtkTransform> transform;
    transform->RotateZ(360.0 / number * i);
    transform->Translate(radius, 0.0, 0.0);
    transform->RotateX(90.0);
    transform->RotateX(i % 2 == 0 ? 25.0 : -25.0);
    small->SetTransform(transform);
    rings->AddOperand(small);
  }
  return rings;
}

Object MakeTwoSpheres()
{
  auto spheres = vtkSmartPointer<vtkSpatialOperation>::New();
  spheres->AddOperand(MakeSphere({ 0.0, 0.0, 0.0 }, 0.5, Blue));
  spheres->AddOperand(MakeSphere({ 0.4, -0.32, 0.5 }, 0.28, Orange));
  return spheres;
}

Object MakeHypertextureSphere()
{
  Primitive sphere = MakeSphere({ 0.0, 0.0, 0.0 }, 0.5, { 0.80, 0.62, 0.42 });
  sphere->SetEdgeWidth(0.06);
  vtkNew<vtkSpatialTurbulence> turbulence;
  turbulence->SetOperand(sphere);
  turbulence->SetSum(vtkTurbulenceSource::FRACTAL_SUM);
  turbulence->SetNumberOfOctaves(5);
  turbulence->SetFrequency(4.0);
  turbulence->SetAmplitude(0.18);
  turbulence->SetSeed(3);
  // Trim to a box of this half size, which contains the displaced sphere, because the bounds
  // computed for the displacement are larger than necessary.
  constexpr double reach = 0.75;
  auto trimmed = vtkSmartPointer<vtkSpatialOperation>::New();
  trimmed->SetOperationToTrim();
  trimmed->AddOperand(turbulence);
  trimmed->AddOperand(
    MakeBox({ -reach, -reach, -reach }, { reach, reach, reach }, { 1.0, 1.0, 1.0 }));
  return trimmed;
}

Object MakeTeddyBear()
{
  constexpr double edge = 0.3;
  vtkNew<vtkSpatialOperation> body;
  body->SetOperationToBlend();
  body->AddOperand(MakeEllipsoid({ 0.0, 0.0, 0.40 }, { 0.31, 0.27, 0.36 }, edge, Fur));
  body->AddOperand(MakeEllipsoid({ 0.0, -0.03, 0.92 }, { 0.27, 0.25, 0.25 }, edge, Fur));
  body->AddOperand(MakeEllipsoid({ 0.0, -0.25, 0.86 }, { 0.12, 0.10, 0.09 }, edge, PaleFur));
  for (double side : { -1.0, 1.0 })
  {
    body->AddOperand(MakeEllipsoid({ side * 0.21, 0.0, 1.13 }, { 0.11, 0.07, 0.11 }, edge, Fur));
    body->AddOperand(MakeEllipsoid({ side * 0.35, -0.12, 0.52 }, { 0.12, 0.19, 0.12 }, edge, Fur));
    body->AddOperand(MakeEllipsoid({ side * 0.25, -0.26, 0.15 }, { 0.14, 0.26, 0.14 }, edge, Fur));
    body->AddOperand(
      MakeEllipsoid({ side * 0.25, -0.50, 0.16 }, { 0.09, 0.05, 0.10 }, edge, PaleFur));
  }
  vtkNew<vtkSpatialTurbulence> fur;
  fur->SetOperand(body);
  fur->SetModeToErosion();
  fur->SetFrequency(24.0);
  fur->SetNumberOfOctaves(3);
  fur->SetAmplitude(0.9);
  fur->SetGain(4.0);
  auto bear = vtkSmartPointer<vtkSpatialOperation>::New();
  bear->AddOperand(MakeSphere({ -0.10, -0.255, 0.98 }, 0.032, Black));
  bear->AddOperand(MakeSphere({ 0.10, -0.255, 0.98 }, 0.032, Black));
  bear->AddOperand(MakeEllipsoid({ 0.0, -0.345, 0.89 }, { 0.045, 0.03, 0.032 }, 0.0, Black));
  bear->AddOperand(fur);
  return bear;
}

Object MakeRoom()
{
  vtkNew<vtkSpatialOperation> wall;
  wall->SetOperationToDifference();
  wall->AddOperand(MakeBox({ -1.05, 1.0, -0.05 }, { 1.0, 1.05, 1.5 }, Plaster));
  wall->AddOperand(MakeBox({ -0.4, 0.9, 0.5 }, { 0.4, 1.15, 1.2 }, Plaster));
  auto room = vtkSmartPointer<vtkSpatialOperation>::New();
  room->AddOperand(MakeBox({ -1.05, -1.0, -0.05 }, { 1.0, 1.05, 0.0 }, Wood));
  room->AddOperand(MakeBox({ -1.05, -1.0, -0.05 }, { -1.0, 1.05, 1.5 }, Plaster));
  room->AddOperand(wall);
  room->AddOperand(MakeBox({ -0.4, 1.0, 0.83 }, { 0.4, 1.05, 0.87 }, Wood));
  room->AddOperand(MakeBox({ -0.02, 1.0, 0.5 }, { 0.02, 1.05, 1.2 }, Wood));
  return room;
}

Object MakeDesk()
{
  auto desk = vtkSmartPointer<vtkSpatialOperation>::New();
  desk->AddOperand(MakeBox({ -0.45, -0.25, 0.5 }, { 0.45, 0.25, 0.55 }, Wood));
  AddLegs(desk, 0.45, 0.25, 0.06, 0.5);
  return desk;
}

Object MakeChair()
{
  auto chair = vtkSmartPointer<vtkSpatialOperation>::New();
  chair->AddOperand(MakeBox({ -0.17, -0.17, 0.28 }, { 0.17, 0.17, 0.32 }, Wood));
  chair->AddOperand(MakeBox({ -0.17, 0.13, 0.32 }, { 0.17, 0.17, 0.72 }, Wood));
  AddLegs(chair, 0.17, 0.17, 0.04, 0.28);
  return chair;
}
}

const char* vtkConstructiveModelSource::GetModelName(int model)
{
  static const char* const names[NUMBER_OF_MODELS] = { "fuzzy sphere", "robot", "rings",
    "two spheres", "hypertexture sphere", "teddy bear", "room", "desk", "chair" };
  return model >= 0 && model < NUMBER_OF_MODELS ? names[model] : nullptr;
}

vtkSmartPointer<vtkSpatialObject> vtkConstructiveModelSource::MakeModel(int model)
{
  using Maker = Object (*)();
  static const Maker makers[NUMBER_OF_MODELS] = { MakeFuzzySphere, MakeRobot, MakeRings,
    MakeTwoSpheres, MakeHypertextureSphere, MakeTeddyBear, MakeRoom, MakeDesk, MakeChair };
  return model >= 0 && model < NUMBER_OF_MODELS ? makers[model]() : nullptr;
}

vtkConstructiveModelSource::vtkConstructiveModelSource()
{
  this->SetRoot(MakeModel(this->Model));
  this->FitRoot(this->Resolution);
}

void vtkConstructiveModelSource::SetModel(int model)
{
  const int clamped = std::max(0, std::min(model, NUMBER_OF_MODELS - 1));
  if (this->Model != clamped)
  {
    this->Model = clamped;
    this->SetRoot(MakeModel(clamped));
    this->FitRoot(this->Resolution);
    this->Modified();
  }
}

void vtkConstructiveModelSource::SetResolution(int resolution)
{
  const int clamped = std::max(MinimumResolution, std::min(resolution, MaximumResolution));
  if (this->Resolution != clamped)
  {
    this->Resolution = clamped;
    this->FitRoot(clamped);
    this->Modified();
  }
}

void vtkConstructiveModelSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Model: " << GetModelName(this->Model) << "\n";
  os << indent << "Resolution: " << this->Resolution << "\n";
}
