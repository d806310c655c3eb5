// SPDX-License-Identifier: BSD-3-Clause
// Slice plans: number and direction of sweeps, and the light buffers, for random cameras, lights
// and boxes. Normals are compared with exhaustive search.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceRandom.h"
#include "Support/Light/ReferenceUnitSpace.h"

#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkProjectiveLight.h"
#include "Plan/SlicePlan.h"
#include "Space/UnitVector.h"
#include "vtkMath.h"

namespace
{

using namespace reference;
using namespace interlume::UnitVector;

// Converts an array to a GLM vector.
glm::dvec3 ToVector(const std::array<double, 3>& a)
{
  return glm::make_vec3(a.data());
}

using Box = std::array<std::array<double, 2>, 3>;
using Camera = interlume::SlicePlan::Camera;
using Sweep = interlume::SlicePlan::Sweep;

interlume::UnitSpace MakeCube()
{
  return MakeUnitSpace({ { 65, 65, 65 } }, { { 1.0, 1.0, 1.0 } });
}

std::array<glm::dvec3, 8> GetCorners(const interlume::UnitSpace& space, const Box& box)
{
  std::array<glm::dvec3, 8> corners;
  std::size_t corner = 0;
  for (const double x : box[0])
  {
    for (const double y : box[1])
    {
      for (const double z : box[2])
      {
        corners[corner++] = TransformPoint(space.UnitFromTexture, glm::dvec3(x, y, z));
      }
    }
  }
  return corners;
}

glm::dvec3 GetRay(const glm::dvec3& from, const glm::dvec3& to)
{
  const glm::dvec3 ray = to - from;
  return Normalize(ray, glm::dvec3(0.0, 0.0, 0.0));
}

Camera MakeParallel(const glm::dvec3& direction)
{
  Camera eye;
  eye.IsParallel = true;
  eye.Direction = direction;
  eye.Position = -4.0 * direction;
  return eye;
}

// Returns a perspective camera with a square frame. \a tangent is the tangent of half the view
// angle. If \a tangent is 0, the matrix is not set.
Camera MakePerspective(const glm::dvec3& position, const glm::dvec3& direction, double tangent)
{
  Camera eye;
  eye.Position = position;
  eye.Direction = direction;
  const glm::dvec3 up = Perpendicular(direction, { 0.0, 1.0, 0.0 });
  const glm::dvec3 right = glm::cross(direction, up);
  const glm::dvec3 rows[3] = { (1.0 / std::max(tangent, 1e-9)) * right,
    (1.0 / std::max(tangent, 1e-9)) * up, direction };
  for (int row = 0; row < 3 && tangent > 0.0; ++row)
  {
    eye.ClipFromUnit = glm::row(
      eye.ClipFromUnit, row == 2 ? 3 : row, glm::dvec4(rows[row], -glm::dot(rows[row], position)));
  }
  return eye;
}

interlume::LightSource MakeDirectional(const glm::dvec3& direction)
{
  interlume::LightSource light;
  light.Direction = direction;
  light.ShadowStrength = 1.0;
  return light;
}

interlume::LightSource MakePositional(const glm::dvec3& position)
{
  interlume::LightSource light = MakeDirectional(glm::dvec3(0.0, 0.0, -1.0));
  light.IsPositional = true;
  light.Position = position;
  return light;
}

interlume::SlicePlan Plan(const Camera& eye, const std::vector<interlume::LightSource>& lights,
  const interlume::UnitSpace& space, const interlume::SlicePlan::Settings& settings = {})
{
  interlume::SlicePlan plan;
  plan.Make(eye, lights, space, space.Box, settings);
  return plan;
}

std::vector<glm::dvec3> GetRays(
  const interlume::LightSource& light, const std::array<glm::dvec3, 8>& corners)
{
  if (!light.IsPositional)
  {
    return { light.Direction };
  }
  std::vector<glm::dvec3> rays;
  rays.reserve(corners.size());
  for (const glm::dvec3& corner : corners)
  {
    rays.push_back(GetRay(light.Position, corner));
  }
  return rays;
}

double GetMinimum(const std::vector<glm::dvec3>& rays, const glm::dvec3& normal, double sign = 1.0)
{
  double minimum = 1.0;
  for (const glm::dvec3& ray : rays)
  {
    minimum = std::min(minimum, sign * glm::dot(ray, normal));
  }
  return minimum;
}

// Returns normals in all directions, with more of them near \a center.
std::vector<glm::dvec3> GetNormals(const glm::dvec3& center)
{
  std::vector<glm::dvec3> normals = { center };
  constexpr int number = 1500;
  for (int i = 0; i < number; ++i)
  {
    const double z = 1.0 - (2.0 * i + 1.0) / number;
    const double angle = 2.399963229728653 * i;
    const double radius = std::sqrt(1.0 - z * z);
    const glm::dvec3 normal{ radius * std::cos(angle), radius * std::sin(angle), z };
    normals.push_back(normal);
    normals.push_back(Normalize(center + 0.3 * normal, center));
  }
  return normals;
}

void CheckSlabs(Check& check, const interlume::SlicePlan& plan, std::size_t index,
  const std::vector<interlume::LightSource>& lights, const interlume::UnitSpace& space,
  const std::array<glm::dvec3, 8>& corners)
{
  const Sweep& sweep = plan.Sweeps[index];
  double lower = VTK_DOUBLE_MAX;
  double upper = -VTK_DOUBLE_MAX;
  for (const glm::dvec3& corner : corners)
  {
    lower = std::min(lower, glm::dot(corner, sweep.Normal));
    upper = std::max(upper, glm::dot(corner, sweep.Normal));
  }
  // A sweep may start at the first of its lights if another sweep draws the part of the volume
  // before that light, or if that part is not visible.
  const bool isFirstHalf = !plan.IsLastInImage(index);
  const bool isHalf = isFirstHalf || sweep.IsBehind;
  if (isHalf || (index > 0 && !sweep.IsFrontToBack))
  {
    double first = VTK_DOUBLE_MAX;
    for (const interlume::SlicePlan::ShadowedLight& light : sweep.Lights)
    {
      const glm::dvec3& position = lights[static_cast<std::size_t>(light.Light)].Position;
      first = std::min(first, light.IsWide ? glm::dot(position, sweep.Normal) : lower);
    }
    lower = std::max(lower, first);
  }
  if (isFirstHalf)
  {
    const Sweep& second = plan.Sweeps[index + 1];
    check.That(!sweep.IsFrontToBack && second.IsFrontToBack && second.IsBehind && !sweep.IsBehind,
      "first from the light toward the camera, then away from it");
    check.That(second.Normal == -sweep.Normal, "both halves have the same planes");
    check.Near(second.First, -sweep.First, 1e-9, "the halves meet at the light");
    check.That(sweep.Lights.size() == 1 && second.Lights.size() == 1 &&
        sweep.Lights[0].Light == second.Lights[0].Light,
      "both halves have the same single light");
  }
  check.That(!sweep.IsBehind || index > 0, "the first sweep is not behind another sweep");
  check.Near(interlume::Vectors::SafeLength(sweep.Normal), 1.0, 1e-12, "length of the normal");
  check.Near(sweep.First, lower, 1e-12, "the first slab starts at the lowest vertex or light", 1.0);
  check.Near(sweep.First + sweep.Slabs * sweep.Spacing, upper, 1e-12,
    "the last slab ends at the highest vertex", 1.0);
  const double voxel = interlume::SlicePlan::GetVoxelSpacing(space, sweep.Normal);
  // No line inside a voxel is longer than the sum of the voxel's edge lengths.
  double maximumLength = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    maximumLength += interlume::Vectors::SafeLength(glm::dvec3(space.UnitFromTexture[axis])) /
      static_cast<double>(space.Size[axis]);
  }
  check.That(sweep.Spacing <= std::max(voxel, maximumLength) * (1.0 + 1e-8),
    "slabs are at most as thick as a voxel");
  check.That((sweep.Slabs - 1) * voxel < upper - lower, "there are no unnecessary slabs");
}

// Checks that the volume's vertices fill the buffer exactly, except for its border of two texels.
void CheckBuffer(Check& check, const interlume::SlicePlan::ShadowedLight& light,
  const std::array<glm::dvec3, 8>& corners, double distance)
{
  const double border = 1.0 - 4.0 / light.BufferSize;
  double lower[2] = { 1.0, 1.0 };
  double upper[2] = { -1.0, -1.0 };
  for (const glm::dvec3& corner : corners)
  {
    const glm::dvec4 point = light.BufferFromUnit * glm::dvec4(corner, 1.0);
    check.That(point.w > 0.0, "vertices are in front of the light");
    for (int i = 0; i < 2; ++i)
    {
      lower[i] = std::min(lower[i], point[i] / point.w);
      upper[i] = std::max(upper[i], point[i] / point.w);
    }
  }
  const double tolerance = 1e-9 + 1e-14 * distance;
  for (int i = 0; i < 2; ++i)
  {
    check.Near(lower[i], -border, tolerance, "lower edge of the box in the buffer");
    check.Near(upper[i], border, tolerance, "upper edge of the box in the buffer");
  }
}

void CheckFrame(Check& check, const interlume::SlicePlan::ShadowedLight& light, const Sweep& sweep)
{
  for (std::size_t i = 0; i < 3; ++i)
  {
    for (std::size_t j = 0; j < 3; ++j)
    {
      check.Near(vtkMath::Dot(light.Frame.data() + 3 * i, light.Frame.data() + 3 * j),
        i == j ? 1.0 : 0.0, 1e-12, "the frame is orthonormal", 1.0);
    }
    check.Near(light.Frame[6 + i], sweep.Normal[i], 1e-12, "its third row is the normal", 1.0);
  }
}

// Checks the sweeps of any plan: slices face the camera, each light illuminates the full volume
// exactly once, and buffers and slabs are correct.
void CheckSweeps(Check& check, const interlume::SlicePlan& plan, const Camera& eye,
  const std::vector<interlume::LightSource>& lights, const interlume::UnitSpace& space, int maximum)
{
  const std::array<glm::dvec3, 8> corners = GetCorners(space, space.Box);
  std::vector<int> narrow(lights.size());
  std::vector<std::vector<glm::dvec3>> wide(lights.size());
  for (std::size_t index = 0; index < plan.Sweeps.size(); ++index)
  {
    const Sweep& sweep = plan.Sweeps[index];
    CheckSlabs(check, plan, index, lights, space, corners);
    check.That(static_cast<int>(sweep.Lights.size()) <= maximum, "number of lights of a sweep");
    const double sign = sweep.IsFrontToBack ? 1.0 : -1.0;
    check.That(sign * glm::dot(eye.Direction, sweep.Normal) > 0.0, "the side of the camera");
    for (const interlume::SlicePlan::ShadowedLight& light : sweep.Lights)
    {
      const auto index = static_cast<std::size_t>(light.Light);
      const interlume::LightSource& source = lights[index];
      if (light.IsWide)
      {
        wide[index].push_back(sweep.Normal);
        CheckFrame(check, light, sweep);
        continue;
      }
      ++narrow[index];
      const std::vector<glm::dvec3> rays = GetRays(source, corners);
      // Directional lights are never wide, so their cosine may be smaller if the camera is close to
      // the volume.
      const double minimum = source.IsPositional ? interlume::SlicePlan::WideCosine - 1e-9 : 0.05;
      check.That(
        GetMinimum(rays, sweep.Normal) >= minimum, "minimum cosine of a light that is not wide");
      if (std::count_if(sweep.Lights.begin(), sweep.Lights.end(),
            [](const interlume::SlicePlan::ShadowedLight& other) { return !other.IsWide; }) > 1)
      {
        check.That(GetMinimum(rays, sweep.Normal) >= interlume::SlicePlan::LightCosine - 1e-9,
          "minimum cosine of lights that share a sweep");
      }
      CheckBuffer(check, light, corners,
        source.IsPositional ? interlume::Vectors::SafeLength(source.Position) : 0.0);
    }
  }
  for (std::size_t i = 0; i < lights.size(); ++i)
  {
    const std::string name = "light " + std::to_string(i);
    if (!(lights[i].ShadowStrength > 0.0) || narrow[i] > 0)
    {
      check.Equal(narrow[i], lights[i].ShadowStrength > 0.0 ? 1 : 0, name + " exactly once");
      check.That(wide[i].empty(), name + " is not wide in another sweep");
      continue;
    }
    check.That(wide[i].size() == 1 || wide[i].size() == 2, name + " has one or two half spaces");
    check.That(wide[i].size() < 2 || wide[i][0] == -wide[i][1], name + " has opposite half spaces");
    for (const glm::dvec3& side : wide[i])
    {
      double maximum = 0.0;
      for (const glm::dvec3& corner : corners)
      {
        maximum = std::max(maximum, glm::dot(corner - lights[i].Position, side));
      }
      check.That(maximum > 0.0, name + " has a part of the volume on each side");
    }
    for (const glm::dvec3& corner : corners)
    {
      const bool isLit = std::any_of(wide[i].begin(), wide[i].end(),
        [&](const glm::dvec3& side)
        { return glm::dot(corner - lights[i].Position, side) >= -1e-8; });
      check.That(isLit, name + " illuminates the full volume");
    }
  }
}

// The cosines of view and light rays with the normal of a plan are at least ViewCosine and
// LightCosine if any normal achieves this.
void CheckAngles(Check& check, const interlume::SlicePlan& plan,
  const std::vector<glm::dvec3>& eyeRays, const interlume::LightSource& light,
  const std::array<glm::dvec3, 8>& corners)
{
  const Sweep& sweep = plan.Sweeps.front();
  const std::vector<glm::dvec3> rays = GetRays(light, corners);
  const double sign = sweep.IsFrontToBack ? 1.0 : -1.0;
  const auto isGood = [&](const glm::dvec3& normal, double side, double tolerance)
  {
    return GetMinimum(eyeRays, normal, side) >= interlume::SlicePlan::ViewCosine - tolerance &&
      GetMinimum(rays, normal) >= interlume::SlicePlan::LightCosine - tolerance;
  };
  const bool isBounded = !sweep.Lights.front().IsWide && isGood(sweep.Normal, sign, 1e-9);
  const std::vector<glm::dvec3> normals = GetNormals(sweep.Normal);
  check.That(isBounded ||
      std::none_of(normals.begin(), normals.end(),
        [&](const glm::dvec3& normal)
        { return isGood(normal, 1.0, -1e-6) || isGood(normal, -1.0, -1e-6); }),
    "all angles are within bounds if a normal exists");
}

interlume::UnitSpace MakeRandomSpace(Random& random)
{
  std::array<int, 3> size;
  std::array<double, 3> spacing;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    size[axis] = static_cast<int>(random.Get(2.0, 80.0));
    spacing[axis] = std::exp(random.Get(-1.0, 1.0));
  }
  return MakeUnitSpace(size, spacing, random.Get(-1.0, 1.0));
}

double GetRandomDistance(Random& random)
{
  return random.Get(0.0, 1.0) < 0.5 ? random.Get(1.0, 4.0) : std::exp(random.Get(-7.0, 14.0));
}

void CheckRandomLight(Check& check)
{
  Random random(5);
  for (int i = 0; i < 4000; ++i)
  {
    check.SetContext("one light, case " + std::to_string(i));
    const interlume::UnitSpace space = MakeRandomSpace(random);
    const std::array<glm::dvec3, 8> corners = GetCorners(space, space.Box);
    const glm::dvec3 view = ToVector(random.GetDirection());
    const bool isParallel = i % 3 == 0;
    const glm::dvec3 position =
      -random.Get(1.1, 10.0) * view + 0.2 * ToVector(random.GetDirection());
    const Camera eye = isParallel ? MakeParallel(view) : MakePerspective(position, view, 0.0);
    const interlume::LightSource light = i % 2
      ? MakeDirectional(ToVector(random.GetDirection()))
      : MakePositional(GetRandomDistance(random) * ToVector(random.GetDirection()));
    const interlume::SlicePlan plan = Plan(eye, { light }, space);
    CheckSweeps(check, plan, eye, { light }, space, 4);
    std::vector<glm::dvec3> rays = { view };
    if (!isParallel)
    {
      rays = GetRays(MakePositional(position), corners);
    }
    CheckAngles(check, plan, rays, light, corners);
  }
}

// Visible slices are in order along each view ray, for any camera position and all kinds of lights.
void CheckRandomLights(Check& check)
{
  Random random(5);
  for (int i = 0; i < 2000; ++i)
  {
    check.SetContext("many lights, case " + std::to_string(i));
    const interlume::UnitSpace space = MakeRandomSpace(random);
    const glm::dvec3 view = ToVector(random.GetDirection());
    const double tangent = random.Get(0.05, 1.0);
    const glm::dvec3 position = ToVector(random.GetPoint(0.2)) - random.Get(0.0, 3.0) * view;
    const Camera eye = i % 4 == 0 ? MakeParallel(view) : MakePerspective(position, view, tangent);
    std::vector<interlume::LightSource> lights;
    for (int number = i % 9; number > 0; --number)
    {
      lights.push_back(random.Get(0.0, 1.0) < 0.5
          ? MakeDirectional(ToVector(random.GetDirection()))
          : MakePositional(GetRandomDistance(random) * ToVector(random.GetDirection())));
      lights.back().ShadowStrength = number % 4 == 0 ? 0.0 : 0.7;
    }
    interlume::SlicePlan::Settings settings;
    settings.LightsOfSweep = 1 + i % 4;
    const interlume::SlicePlan plan = Plan(eye, lights, space, settings);
    CheckSweeps(check, plan, eye, lights, space, settings.LightsOfSweep);
    for (int sample = 0; sample < 50 && !eye.IsParallel; ++sample)
    {
      const glm::dvec3 up = Perpendicular(view, { 0.0, 1.0, 0.0 });
      const glm::dvec3 right = glm::cross(view, up);
      const glm::dvec3 ray =
        view + random.Get(-tangent, tangent) * right + random.Get(-tangent, tangent) * up;
      const bool isSeen = [&]
      {
        const glm::dvec3 point =
          TransformPoint(space.TextureFromUnit, position + random.Get(0.0, 5.0) * ray);
        return std::min({ point.x, point.y, point.z }) > 0.0 &&
          std::max({ point.x, point.y, point.z }) < 1.0;
      }();
      for (const Sweep& sweep : plan.Sweeps)
      {
        const double sign = sweep.IsFrontToBack ? 1.0 : -1.0;
        check.That(!isSeen ||
            sign * glm::dot(ray, sweep.Normal) > 0.05 * interlume::Vectors::SafeLength(ray),
          "a view ray passes the slabs in order");
      }
    }
  }
}

void CheckHalfVector(Check& check)
{
  const interlume::UnitSpace space = MakeCube();
  Random random(5);
  for (int i = 0; i < 500; ++i)
  {
    const glm::dvec3 view = ToVector(random.GetDirection());
    const glm::dvec3 light = i == 0 ? view : (i == 1 ? (-view) : ToVector(random.GetDirection()));
    check.SetContext("half vector, case " + std::to_string(i));
    const bool isInFront = glm::dot(view, light) >= 0.0;
    const glm::dvec3 half = light + (isInFront ? 1.0 : -1.0) * view;
    const Sweep sweep = Plan(MakeParallel(view), { MakeDirectional(light) }, space).Sweeps.front();
    check.That(sweep.IsFrontToBack == isInFront, "the side");
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      check.Near(sweep.Normal[axis], half[axis] / interlume::Vectors::SafeLength(half), 1e-12,
        "normal", 1.0);
    }
  }
}

// The light rotates from the view direction to its opposite in steps of 0.01 degrees. The normal of
// the slices changes continuously, except at 90 degrees, where the slice order changes.
void CheckContinuity(Check& check)
{
  const interlume::UnitSpace space = MakeCube();
  const glm::dvec3 view{ 0.0, 0.0, -1.0 };
  for (const bool isPositional : { false, true })
  {
    for (const double distance : { 1e6, 12.0, 3.0, 2.0 })
    {
      const Camera eye = distance > 1e5
        ? MakeParallel(view)
        : MakePerspective(glm::dvec3(0.0, 0.0, distance), view, 0.0);
      int changes = 0;
      Sweep before;
      for (int step = 0; step <= 18000; ++step)
      {
        const double angle = vtkMath::RadiansFromDegrees(0.01 * step);
        const glm::dvec3 light{ std::sin(angle), 0.0, -std::cos(angle) };
        const Sweep sweep =
          Plan(eye, { isPositional ? MakePositional(-2.5 * light) : MakeDirectional(light) }, space)
            .Sweeps.front();
        check.That(!sweep.Lights.front().IsWide, "the light is outside the volume");
        if (step > 0 && sweep.IsFrontToBack != before.IsFrontToBack)
        {
          ++changes;
          check.Near(0.01 * step, 90.0, 1.2e-4, "angle where the side changes");
        }
        else if (step > 0)
        {
          check.That(interlume::Vectors::SafeLength(sweep.Normal - before.Normal) < 1e-3,
            "the normal is discontinuous at " + std::to_string(0.01 * step) + " degrees from " +
              std::to_string(distance));
        }
        before = sweep;
      }
      check.Equal(changes, 1, "number of side changes at distance " + std::to_string(distance));
    }
  }
}

struct Case
{
  std::string Name;
  std::vector<interlume::LightSource> Lights;
  int Sweeps;
  int FrontToBack;
  int Wide;
};

void CheckCounts(Check& check)
{
  check.SetContext("");
  const interlume::UnitSpace space = MakeCube();
  const double side = space.UnitFromTexture[0][0] / 2.0;
  const glm::dvec3 eye{ 0.0, 0.0, 4.0 };
  const interlume::LightSource front = MakeDirectional(glm::dvec3(0.0, 0.0, -1.0));
  const interlume::LightSource back = MakeDirectional(glm::dvec3(0.0, 0.0, 1.0));
  const interlume::LightSource oblique = MakeDirectional(glm::dvec3(0.6, 0.0, -0.8));
  const interlume::LightSource behindSide = MakeDirectional(glm::dvec3(0.995037, 0.0, 0.0995037));
  interlume::LightSource none = front;
  none.ShadowStrength = 0.0;
  const std::vector<Case> cases = {
    { "no lights", {}, 1, 1, 0 },
    { "no shadows", { none, none }, 1, 1, 0 },
    { "with the view", { front }, 1, 1, 0 },
    { "against the view", { back }, 1, 0, 0 },
    { "front and back", { front, back }, 2, 1, 0 },
    { "two in front", { front, oblique }, 1, 1, 0 },
    { "two lights, one slightly behind the volume, in one sweep", { oblique, behindSide }, 1, 1,
      0 },
    { "five lights, more than one sweep may have", { front, front, front, front, front }, 2, 2, 0 },
    { "at the camera", { MakePositional(eye) }, 1, 1, 0 },
    { "opposite", { MakePositional(glm::dvec3(0.0, 0.0, -4.0)) }, 1, 0, 0 },
    { "inside", { MakePositional(glm::dvec3(0.0, 0.0, 0.0)) }, 2, 1, 2 },
    { "inside, off center", { MakePositional(glm::dvec3(0.1, 0.2, 0.3)) }, 2, 1, 2 },
    { "a thousandth inside", { MakePositional(glm::dvec3(0.0, 0.0, side - 1e-3)) }, 2, 1, 2 },
    { "in the front face", { MakePositional(glm::dvec3(0.0, 0.0, side)) }, 1, 1, 1 },
    { "a thousandth in front", { MakePositional(glm::dvec3(0.0, 0.0, side + 1e-3)) }, 1, 1, 1 },
    { "a thousandth behind", { MakePositional(glm::dvec3(0.0, 0.0, -side - 1e-3)) }, 1, 0, 1 },
    { "a thousandth to the side", { MakePositional(glm::dvec3(side + 1e-3, 0.0, 0.0)) }, 2, 1, 2 },
    { "at a million", { MakePositional(glm::dvec3(1e6, 0.0, 1e6)) }, 1, 1, 0 },
    { "at 1e12", { MakePositional(glm::dvec3(1e12, 0.0, -1e12)) }, 1, 0, 0 },
    { "one inside, one in front", { front, MakePositional(glm::dvec3(0.0, 0.0, 0.0)) }, 2, 1, 2 },
    { "one in the front face, one in front", { front, MakePositional(glm::dvec3(0.0, 0.0, side)) },
      1, 1, 1 },
    { "two inside",
      { MakePositional(glm::dvec3(0.0, 0.0, 0.0)), MakePositional(glm::dvec3(0.1, 0.2, 0.3)) }, 2,
      1, 4 },
  };
  for (const Case& one : cases)
  {
    const Camera view = MakePerspective(eye, glm::dvec3(0.0, 0.0, -1.0), 0.27);
    const interlume::SlicePlan plan = Plan(view, one.Lights, space);
    CheckSweeps(check, plan, view, one.Lights, space, 4);
    int frontToBack = 0;
    int wide = 0;
    for (const Sweep& sweep : plan.Sweeps)
    {
      frontToBack += sweep.IsFrontToBack ? 1 : 0;
      for (const interlume::SlicePlan::ShadowedLight& light : sweep.Lights)
      {
        wide += light.IsWide ? 1 : 0;
      }
    }
    check.Equal(static_cast<long long>(plan.Sweeps.size()), one.Sweeps, one.Name + ": sweeps");
    check.Equal(frontToBack, one.FrontToBack, one.Name + ": front to back");
    check.Equal(wide, one.Wide, one.Name + ": half spaces");
  }
}

// A light inside the volume adds at most one slab.
void CheckHalves(Check& check)
{
  check.SetContext("halves");
  const interlume::UnitSpace space = MakeCube();
  const Camera eye = MakePerspective(glm::dvec3(0.0, 0.0, 4.0), glm::dvec3(0.0, 0.0, -1.0), 0.27);
  const auto count = [&](const std::vector<interlume::LightSource>& lights)
  {
    int slabs = 0;
    for (const Sweep& sweep : Plan(eye, lights, space).Sweeps)
    {
      slabs += sweep.Slabs;
    }
    return slabs;
  };
  const int full = count({});
  const interlume::LightSource inside = MakePositional(glm::dvec3(0.1, 0.2, 0.3));
  check.That(count({ inside }) <= full + 1, "a light inside: slabs of one sweep");
  const interlume::SlicePlan plan = Plan(eye, { inside }, space);
  check.That(plan.IsInFirstImage(0) && plan.IsInFirstImage(1) && !plan.HasMultipleImages(),
    "a light inside: one image");
  // With two lights, the back-to-front sweep starts at the light farther from the camera.
  const interlume::LightSource far = MakePositional(glm::dvec3(0.0, 0.0, -0.2));
  check.That(count({ inside, far }) < 1.8 * full, "two lights inside: fewer than two sweeps");
  const interlume::SlicePlan two = Plan(eye, { inside, far }, space);
  check.That(two.HasMultipleImages() && two.Sweeps[0].IsFrontToBack && !two.Sweeps[1].IsBehind,
    "two lights inside: two images, the first of which is complete");
}

void CheckDenseMedium(Check& check)
{
  const interlume::UnitSpace space = MakeUnitSpace({ { 101, 201, 3 } }, { { 1.0, 1.0, 50.0 } });
  const Camera eye = MakeParallel(glm::dvec3(0.0, 0.0, -1.0));
  interlume::SlicePlan::Settings settings;
  settings.SmallerImageSize = 1000;
  // Slabs are 50 units thick, so \a depth is their optical depth.
  const auto getSize = [&](double depth)
  {
    const interlume::SlicePlan::SlicedVolume volume = { &space, space.Box, 0.0,
      depth * space.Radius / 50.0 };
    interlume::SlicePlan plan;
    plan.Make(eye, { MakeDirectional(glm::dvec3(0.0, 0.0, -1.0)) }, { volume }, settings);
    return plan.Sweeps[0].Lights[0].BufferSize;
  };
  check.Equal(getSize(0.99), 208, "low density: one texel per voxel");
  check.Equal(getSize(1.01), 304, "dense medium: 1.5 texels per voxel");
  settings.SmallerImageSize = 260;
  check.Equal(getSize(1.01), 256, "at most one texel per pixel");
  settings.SmallerImageSize = 100;
  check.Equal(getSize(1.01), 208, "a small image: at least one texel per voxel");
  settings.SmallerImageSize = 1000;
  settings.BufferSize = 100;
  check.Equal(getSize(1.01), 100, "dense medium: explicit size");
}

void CheckSettings(Check& check)
{
  const interlume::UnitSpace space = MakeUnitSpace({ { 101, 201, 3 } }, { { 1.0, 1.0, 50.0 } });
  const Camera eye = MakeParallel(glm::dvec3(0.0, 0.0, -1.0));
  const std::vector<interlume::LightSource> lights = { MakeDirectional(
    glm::dvec3(0.0, 0.0, -1.0)) };
  interlume::SlicePlan::Settings settings;
  const auto make = [&] { return Plan(eye, lights, space, settings).Sweeps.front(); };
  check.Equal(make().Slabs, 2, "one slab per voxel along the normal");
  check.Equal(make().Lights[0].BufferSize, 208, "200 voxels across, plus the border");
  settings.AutomaticFactor = 0.25;
  check.Equal(make().Slabs, 8, "a quarter of the spacing");
  settings.Spacing = 30.0 / space.Radius;
  check.Equal(make().Slabs, 4, "a length of 100 in slabs of at most 30");
  check.Near(make().Spacing * space.Radius, 25.0, 1e-9, "slabs of 25");
  settings.MaximumNumberOfSlabs = 3;
  check.Equal(make().Slabs, 3, "at most 3 slabs");
  settings.Spacing = 1e-300;
  check.Equal(make().Slabs, 3, "at most 3 slabs for any spacing");
  settings.BufferSize = 100;
  check.Equal(make().Lights[0].BufferSize, 100, "explicit size");
  settings.LargestBufferSize = 90;
  check.Equal(make().Lights[0].BufferSize, 90, "explicit size, limited");
  settings.BufferSize = 0;
  check.Equal(make().Lights[0].BufferSize, 90, "automatic size, limited");
  settings.LargestBufferSize = 8192;
  check.Equal(
    Plan(eye, lights, MakeCube(), settings).Sweeps[0].Lights[0].BufferSize, 80, "64 voxels");
  check.Equal(Plan(eye, lights, MakeUnitSpace({ { 9, 9, 9 } }, { { 1.0, 1.0, 1.0 } }), settings)
                .Sweeps[0]
                .Lights[0]
                .BufferSize,
    64, "smallest automatic size");
  check.Equal(Plan(eye, lights, MakeUnitSpace({ { 5001, 9, 9 } }, { { 1.0, 1.0, 1.0 } }), settings)
                .Sweeps[0]
                .Lights[0]
                .BufferSize,
    2048, "largest automatic size");
  // Volumes of 100 x 100 x 50 voxels, shaped like a sheet or a needle, in oblique light.
  const std::vector<interlume::LightSource> oblique = { MakeDirectional(
    Normalize(glm::dvec3(0.3, -0.4, -1.0), {})) };
  const auto getSize = [&](const std::array<double, 3>& spacing)
  {
    const interlume::UnitSpace volume = MakeUnitSpace({ { 101, 101, 51 } }, spacing);
    return Plan(eye, oblique, volume, settings).Sweeps[0].Lights[0].BufferSize;
  };
  check.Equal(getSize({ { 1.0, 1.0, 1e-9 } }), getSize({ { 1.0, 1.0, 1e-6 } }),
    "the thickness of a sheet below a texel does not affect the size");
  check.That(getSize({ { 1.0, 1.0, 1e-9 } }) <= 160, "a sheet needs texels for its area");
  check.That(getSize({ { 1.0, 1e9, 1.0 } }) <= 160, "a needle needs texels along its length");
  check.Equal(getSize({ { 1.0, 1.0, 0.01 } }), 2048, "a thicker sheet needs more texels");

  const glm::dvec3 voxel{ 1.0 / space.Radius, 1.0 / space.Radius, 50.0 / space.Radius };
  Random random(5);
  for (int i = 0; i < 100; ++i)
  {
    const glm::dvec3 n = ToVector(random.GetDirection());
    const glm::dvec3 a{ n[0] / voxel[0], n[1] / voxel[1], n[2] / voxel[2] };
    check.Near(interlume::SlicePlan::GetVoxelSpacing(space, n), 1.0 / std::sqrt(glm::dot(a, a)),
      1e-12, "length of a voxel along a normal");
  }
}

// If the screen of a projective light is smaller than the volume, the screen's corners are at the
// buffer's border.
void CheckScreens(Check& check)
{
  const interlume::UnitSpace space = MakeCube();
  const Camera eye = MakeParallel(glm::dvec3(0.0, 0.0, -1.0));
  for (const bool isPositional : { false, true })
  {
    check.SetContext(
      isPositional ? "screen of a positional light" : "screen of a directional light");
    vtkNew<vtkProjectiveLight> projective;
    projective->SetPositional(isPositional);
    projective->SetPosition(2.0, 0.5, 2.0);
    projective->SetFocalPoint(0.1, 0.0, 0.0);
    projective->SetViewUp(0.3, 1.0, 0.0);
    interlume::LightSource light = isPositional ? MakePositional(glm::dvec3(2.0, 0.5, 2.0))
                                                : MakeDirectional(glm::dvec3(0.0, 0.0, -1.0));
    light.Projective = projective;
    light.Direction = Normalize(glm::dvec3(-1.9, -0.5, -2.0), {});
    const auto make = [&](double width, double height)
    {
      projective->SetScreenSize(width, height);
      vtkNew<vtkMatrix4x4> matrix;
      projective->GetScreenMatrix(matrix);
      light.ScreenFromUnit = FromRows(matrix->GetData());
      return Plan(eye, { light }, space).Sweeps[0].Lights[0];
    };
    const interlume::SlicePlan::ShadowedLight cut = make(0.3, 0.2);
    const double border = 1.0 - 4.0 / cut.BufferSize;
    const glm::dvec3 up = Perpendicular(light.Direction, { 0.3, 1.0, 0.0 });
    const glm::dvec3 right = glm::cross(light.Direction, up);
    for (const double u : { -1.0, 1.0 })
    {
      for (const double v : { -1.0, 1.0 })
      {
        const glm::dvec3 corner = glm::dvec3(0.1, 0.0, 0.0) + (0.15 * u) * right + (0.1 * v) * up;
        const glm::dvec4 to = cut.BufferFromUnit * glm::dvec4(corner, 1.0);
        check.That(to[3] > 0.0, "w is positive in front");
        check.Near(to[0] / to[3], u * border, 1e-9, "across");
        check.Near(to[1] / to[3], v * border, 1e-9, "up");
      }
    }
    CheckBuffer(check, make(100.0, 100.0), GetCorners(space, space.Box), 0.0);
    check.Equal(cut.BufferSize, 64, "a small screen needs few texels");
  }
}

// A camera that is extremely far away has no finite position. The view direction is used instead of
// rays to vertices.
void CheckEyeWithoutPosition(Check& check)
{
  const interlume::UnitSpace space = MakeCube();
  Camera eye = MakeParallel(glm::dvec3(0.0, 0.0, -1.0));
  eye.IsParallel = false;
  eye.Position = glm::dvec3(std::numeric_limits<double>::quiet_NaN());
  check.SetContext("camera without a position");
  check.Equal(Plan(eye, {}, space).Sweeps.front().Normal == eye.Direction, true,
    "the normal is along the view");
  const Sweep sweep = Plan(eye, { MakeDirectional(glm::dvec3(0.0, -1.0, 0.0)) }, space).Sweeps[0];
  check.Near(glm::length(sweep.Normal), 1.0, 1e-12, "length of the normal", 1.0);
}

void CheckOctahedralMap(Check& check)
{
  Random random(5);
  for (int i = 0; i < 1000; ++i)
  {
    const glm::dvec3 normal = ToVector(random.GetDirection());
    const glm::dvec3 first = Perpendicular(normal, ToVector(random.GetDirection()));
    const glm::dvec3 second = glm::cross(normal, first);
    std::array<double, 9> frame;
    std::copy_n(glm::value_ptr(first), 3, frame.begin());
    std::copy_n(glm::value_ptr(second), 3, frame.begin() + 3);
    std::copy_n(glm::value_ptr(normal), 3, frame.begin() + 6);
    glm::dvec3 direction = ToVector(random.GetDirection());
    const double along = glm::dot(direction, normal);
    // Every fifth direction is on the boundary of the half space.
    direction = Normalize(
      (along < 0.0 ? -1.0 : 1.0) * direction + (i % 5 ? 0.0 : -std::abs(along)) * normal, normal);
    const std::array<double, 2> position =
      interlume::SlicePlan::GetBufferPosition(frame, random.Get(0.1, 10.0) * direction);
    const glm::dvec3 back = interlume::SlicePlan::GetBufferDirection(frame, position);
    for (const double coordinate : position)
    {
      check.That(coordinate > -1e-12 && coordinate < 1.0 + 1e-12, "inside the buffer");
    }
    check.Near(glm::dot(back, direction), 1.0, 1e-12, "mapped back to the direction");
    const double x = glm::dot(direction, first);
    const double y = glm::dot(direction, second);
    const double size = std::abs(x) + std::abs(y) + glm::dot(direction, normal);
    check.Near(position[0], 0.5 + 0.5 * (x + y) / size, 1e-12, "first coordinate", 1.0);
    check.Near(position[1], 0.5 + 0.5 * (x - y) / size, 1e-12, "second coordinate", 1.0);
  }
}
}

int TestSlicePlan(int, char*[])
{
  Check check;
  CheckHalfVector(check);
  CheckContinuity(check);
  CheckCounts(check);
  CheckHalves(check);
  CheckDenseMedium(check);
  CheckSettings(check);
  CheckScreens(check);
  CheckEyeWithoutPosition(check);
  CheckOctahedralMap(check);
  CheckRandomLight(check);
  CheckRandomLights(check);
  return check.Result();
}
