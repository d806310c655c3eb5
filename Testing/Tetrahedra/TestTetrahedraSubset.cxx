// SPDX-License-Identifier: BSD-3-Clause
// Tests the subsets that are drawn during interaction: sums of optical depth and area against those
// of the mesh, nesting, copies of values, odd meshes, threads, and the choice of the level.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceExecution.h"
#include "Support/Tetrahedra/ReferenceTetrahedra.h"

#include "Draw/LevelOfDetail.h"
#include "Draw/TetrahedraSubset.h"
#include "Frame/BoundaryShading.h"

#include "vtkColorTransferFunction.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <tuple>
#include <vector>

namespace
{

using namespace reference;
using interlume::LevelOfDetail;
using interlume::TetrahedraFields;
using interlume::TetrahedraFrame;
using interlume::TetrahedraMesh;
using interlume::TetrahedraSubset;

/// A mesh with cell colors. The red channel is the index of the tetrahedron. Extinction is 0 for x
/// < -0.3 and otherwise varies by a factor of 40.
struct Model
{
  explicit Model(int cubes, bool hasTime = false)
  {
    CubeMeshSettings form;
    form.Cubes = cubes;
    form.Jitter = 0.3;
    this->Mesh = MakeCubeMesh(form);
    this->Fields.Kind = TetrahedraFields::CELL_COLORS;
    for (std::uint32_t t = 0; t < this->Mesh.GetNumberOfTetrahedra(); ++t)
    {
      const double* point = this->Mesh.GetPoint(this->Mesh.GetCorners(t)[0]);
      const double extinction = point[0] < -0.3 ? 0.0 : 0.1 + 4.0 * std::pow(point[1] + 0.5, 2);
      this->Fields.Colors.push_back(
        { { static_cast<float>(t), 0.0f, 0.0f, static_cast<float>(extinction) } });
    }
    for (std::size_t p = 0; hasTime && p < this->Mesh.Points.size() / 3; ++p)
    {
      this->Fields.DeltaT.push_back(static_cast<float>(1.0 + this->Mesh.Points[3 * p + 2]));
    }
  }

  TetrahedraFrame GetFrame() const
  {
    TetrahedraFrame frame;
    frame.Mesh = &this->Mesh;
    frame.Fields = &this->Fields;
    return frame;
  }

  TetrahedraMesh Mesh;
  TetrahedraFields Fields;
};

struct Subset
{
  Subset(const TetrahedraFrame& frame, std::uint32_t number)
  {
    TetrahedraSubset().Update(frame, number, this->Mesh, this->Fields);
  }

  std::set<std::uint32_t> GetIds() const
  {
    std::set<std::uint32_t> ids;
    for (const auto& color : this->Fields.Colors)
    {
      ids.insert(static_cast<std::uint32_t>(color[0]));
    }
    return ids;
  }

  TetrahedraMesh Mesh;
  TetrahedraFields Fields;
};

/// Returns the integrals of extinction times extent in time over the octants of the space.
std::array<double, 8> Integrate(const TetrahedraMesh& mesh, const TetrahedraFields& fields)
{
  std::array<double, 8> sums{};
  for (std::uint32_t t = 0; t < mesh.GetNumberOfTetrahedra(); ++t)
  {
    double extent = 0.0;
    std::array<double, 3> center{};
    for (int k = 0; k < 4; ++k)
    {
      const std::uint32_t id = mesh.GetCorners(t)[k];
      extent += fields.DeltaT.empty() ? 0.25 : 0.25 * fields.DeltaT[id];
      for (int i = 0; i < 3; ++i)
      {
        center[i] += mesh.GetPoint(id)[i];
      }
    }
    sums[(center[0] > 0.0 ? 1 : 0) + (center[1] > 0.0 ? 2 : 0) + (center[2] > 0.0 ? 4 : 0)] +=
      std::abs(mesh.GetVolumeTimesSix(t)) * fields.Colors[t][3] * extent;
  }
  return sums;
}

double Sum(const std::array<double, 8>& values)
{
  double sum = 0.0;
  for (const double value : values)
  {
    sum += value;
  }
  return sum;
}

void CheckSums(Check& check)
{
  for (const bool hasTime : { false, true })
  {
    const Model model(24, hasTime);
    const auto expected = Integrate(model.Mesh, model.Fields);
    for (const std::uint32_t number : { 500u, 2000u, 8000u, 32000u })
    {
      const Subset subset(model.GetFrame(), number);
      const std::string name = std::to_string(number) + (hasTime ? " in time" : "");
      check.Equal(subset.Mesh.GetNumberOfTetrahedra(), number, name + ": number");
      const auto found = Integrate(subset.Mesh, subset.Fields);
      // The standard deviation of a sum of n tetrahedra is at most 1 / sqrt(n).
      check.Near(Sum(found), Sum(expected), 2.0 / std::sqrt(number), name + ": optical depth");
      for (int i = 0; i < 8; ++i)
      {
        check.Near(found[i], expected[i], 4.0 * std::sqrt(Sum(expected) / expected[i] / number),
          name + ": optical depth in octant " + std::to_string(i));
      }
    }
  }
}

void CheckNesting(Check& check)
{
  const Model model(12);
  const TetrahedraFrame frame = model.GetFrame();
  std::set<std::uint32_t> larger = Subset(frame, 5000).GetIds();
  TetrahedraSubset reused;
  for (const std::uint32_t number : { 2500u, 1200u, 100u, 1u })
  {
    const Subset subset(frame, number);
    const std::set<std::uint32_t> ids = subset.GetIds();
    check.Equal(static_cast<long long>(ids.size()), number, "each tetrahedron is drawn once");
    check.That(std::includes(larger.begin(), larger.end(), ids.begin(), ids.end()),
      "a subset contains all smaller ones: " + std::to_string(number));
    Subset changed(frame, 7);
    check.That(reused.Update(frame, number, changed.Mesh, changed.Fields), "updated");
    check.That(changed.Mesh.Points == subset.Mesh.Points &&
        changed.Fields.Colors == subset.Fields.Colors &&
        changed.Fields.DeltaT == subset.Fields.DeltaT,
      "the subset does not depend on earlier ones: " + std::to_string(number));
    check.That(
      !reused.Update(frame, number, changed.Mesh, changed.Fields), "nothing to update again");
    larger = ids;
  }
}

/// Tests a subset that contains all visible tetrahedra.
void CheckAll(Check& check)
{
  Model model(4, true);
  TetrahedraFrame frame = model.GetFrame();
  std::uint32_t visible = 0;
  for (const auto& color : model.Fields.Colors)
  {
    visible += color[3] > 0.0f ? 1 : 0;
  }
  for (const std::uint32_t number : { visible, visible + 1, 100000u })
  {
    const Subset subset(frame, number);
    check.Equal(subset.Mesh.GetNumberOfTetrahedra(), visible, "all visible tetrahedra");
    for (std::uint32_t t = 0; t < subset.Mesh.GetNumberOfTetrahedra(); ++t)
    {
      const auto id = static_cast<std::uint32_t>(subset.Fields.Colors[t][0]);
      bool isSame = subset.Fields.Colors[t] == model.Fields.Colors[id];
      for (int k = 0; k < 4; ++k)
      {
        const std::uint32_t from = model.Mesh.GetCorners(id)[k];
        const std::uint32_t to = subset.Mesh.GetCorners(t)[k];
        isSame = isSame && subset.Fields.DeltaT[to] == model.Fields.DeltaT[from] &&
          std::equal(
            subset.Mesh.GetPoint(to), subset.Mesh.GetPoint(to) + 3, model.Mesh.GetPoint(from));
      }
      check.That(isSame, "a tetrahedron that represents only itself is unchanged");
    }
  }
  // A maximum does not depend on extinction.
  frame.Blend = TetrahedraFrame::MAXIMUM;
  check.Equal(Subset(frame, 100000).Mesh.GetNumberOfTetrahedra(),
    model.Mesh.GetNumberOfTetrahedra(), "all tetrahedra for a maximum");
}

/// Tests values at points, and opacity between the scalars of the corners.
void CheckValues(Check& check)
{
  Model model(6);
  TetrahedraFields& fields = model.Fields;
  fields.Kind = TetrahedraFields::POINT_COLORS;
  fields.Colors.clear();
  for (std::size_t p = 0; p < model.Mesh.Points.size() / 3; ++p)
  {
    fields.Colors.push_back({ { static_cast<float>(p), 1.0f, 0.0f, 2.0f } });
    fields.Scalars.push_back(model.Mesh.Points[3 * p] > 0.01 ? 1.0f : 0.0f);
  }
  for (std::uint32_t t = 0; t < model.Mesh.GetNumberOfTetrahedra(); ++t)
  {
    fields.Layers.push_back(static_cast<int>(model.Mesh.GetCorners(t)[0]));
  }
  const Subset subset(model.GetFrame(), 50);
  for (std::uint32_t t = 0; t < subset.Mesh.GetNumberOfTetrahedra(); ++t)
  {
    const std::uint32_t* corners = subset.Mesh.GetCorners(t);
    check.That(
      subset.Fields.Layers[t] == static_cast<int>(subset.Fields.Colors[corners[0]][0]), "layer");
    for (int k = 0; k < 4; ++k)
    {
      const double* point = subset.Mesh.GetPoint(corners[k]);
      check.That(
        std::all_of(point, point + 3, [](double x) { return std::abs(x) <= 0.5; }), "in the box");
    }
  }

  vtkNew<vtkVolumeProperty> property;
  vtkNew<vtkPiecewiseFunction> opacity;
  for (const auto& [x, y] : { std::array<double, 2>{ { 0.0, 0.0 } }, { { 0.4, 0.0 } },
         { { 0.5, 1.0 } }, { { 0.6, 0.0 } }, { { 1.0, 0.0 } } })
  {
    opacity->AddPoint(x, y);
  }
  property->SetScalarOpacity(opacity);
  interlume::PiecewiseLinearTransferFunction pieces;
  const double range[2] = { 0.0, 1.0 };
  pieces.Build(property, 0, range, 1.0);
  fields.Kind = TetrahedraFields::SCALARS;
  fields.Colors.clear();
  TetrahedraFrame frame = model.GetFrame();
  frame.Pieces = &pieces;
  std::uint32_t crossed = 0;
  for (std::uint32_t t = 0; t < model.Mesh.GetNumberOfTetrahedra(); ++t)
  {
    float sum = 0.0f;
    for (int k = 0; k < 4; ++k)
    {
      sum += fields.Scalars[model.Mesh.GetCorners(t)[k]];
    }
    crossed += sum > 0.0f && sum < 4.0f ? 1 : 0;
  }
  check.That(crossed > 0 && crossed < model.Mesh.GetNumberOfTetrahedra(), "both kinds");
  check.Equal(Subset(frame, 100000).Mesh.GetNumberOfTetrahedra(), crossed,
    "tetrahedra with an opaque layer between transparent corners");
}

/// Tests the area of boundary triangles, here on the side z = 0.5 of the cube.
void CheckArea(Check& check)
{
  Model model(24);
  TetrahedraFields& fields = model.Fields;
  const auto getArea = [](const TetrahedraMesh& mesh, const TetrahedraFields& values)
  {
    double area = 0.0;
    for (std::uint32_t t = 0; t < mesh.GetNumberOfTetrahedra(); ++t)
    {
      for (int face = 0; face < 4 && values.Faces[t]; ++face)
      {
        glm::dvec3 p[3];
        for (int i = 0; i < 3; ++i)
        {
          p[i] = glm::make_vec3(mesh.GetPoint(mesh.GetCorners(t)[(face + 1 + i) % 4]));
        }
        area += (values.Faces[t] >> face) & 1
          ? 0.5 * glm::length(glm::cross(p[1] - p[0], p[2] - p[0]))
          : 0.0;
      }
    }
    return area;
  };
  for (std::uint32_t t = 0; t < model.Mesh.GetNumberOfTetrahedra(); ++t)
  {
    unsigned char faces = 0;
    for (int face = 0; face < 4; ++face)
    {
      bool isOn = true;
      for (int k = 0; k < 4; ++k)
      {
        isOn = isOn && (k == face || model.Mesh.GetPoint(model.Mesh.GetCorners(t)[k])[2] > 0.499);
      }
      faces |= isOn ? 1u << face : 0u;
    }
    fields.Faces.push_back(faces);
  }
  fields.Normals.resize(model.Mesh.Points.size() / 3);
  TetrahedraFrame frame = model.GetFrame();
  interlume::BoundaryShading shading;
  vtkNew<vtkProperty> half;
  half->SetOpacity(0.5);
  vtkNew<vtkRenderer> renderer;
  shading.Set(renderer, frame.View, { { half, nullptr } });
  frame.Surface = &shading;
  const Subset subset(frame, 4000);
  check.Near(getArea(subset.Mesh, subset.Fields), getArea(model.Mesh, fields), 0.15,
    "area of boundary triangles");
  check.Near(Sum(Integrate(subset.Mesh, subset.Fields)), Sum(Integrate(model.Mesh, fields)), 0.05,
    "optical depth with boundary triangles");
}

void CheckOddMeshes(Check& check)
{
  Model model(2);
  TetrahedraFrame frame = model.GetFrame();
  for (const float extinction : { 0.0f, 1e-30f, 1e30f })
  {
    for (auto& color : model.Fields.Colors)
    {
      color[3] = extinction;
    }
    const Subset subset(frame, 7);
    check.Equal(subset.Mesh.GetNumberOfTetrahedra(), extinction > 0.0f ? 7 : 0, "number");
    check.That(std::all_of(subset.Mesh.Points.begin(), subset.Mesh.Points.end(),
                 [](double x) { return std::isfinite(x) && std::abs(x) <= 0.5; }),
      "finite points with extinction " + std::to_string(extinction));
    check.That(std::all_of(subset.Fields.DeltaT.begin(), subset.Fields.DeltaT.end(),
                 [](float x) { return std::isfinite(x) && x >= 0.0f; }),
      "finite extents with extinction " + std::to_string(extinction));
  }
  model.Mesh = TetrahedraMesh();
  model.Fields = TetrahedraFields();
  model.Fields.Kind = TetrahedraFields::CELL_COLORS;
  check.Equal(Subset(frame, 7).Mesh.GetNumberOfTetrahedra(), 0, "empty mesh");
  Append(model.Mesh, { { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } } } });
  model.Fields.Colors = { { { 0.0f, 0.0f, 0.0f, 1.0f } } };
  check.Equal(Subset(frame, 7).Mesh.GetNumberOfTetrahedra(), 1, "one tetrahedron");
}

/// Tests the order of a subset, in which reading the mesh is fast.
void CheckOrder(Check& check)
{
  const Model model(12);
  for (const std::uint32_t number : { 100u, 5000u, 100000u })
  {
    const auto colors = Subset(model.GetFrame(), number).Fields.Colors;
    check.That(
      !colors.empty() && std::is_sorted(colors.begin(), colors.end()), "order of the indices");
  }
}

void CheckThreads(Check& check)
{
  const Model model(30, true);
  CheckSame(
    "subset",
    [&model]()
    {
      const Subset subset(model.GetFrame(), 3000);
      return std::make_tuple(
        subset.Mesh.Points, subset.Mesh.Corners, subset.Fields.Colors, subset.Fields.DeltaT);
    },
    check);
}

void CheckLevels(Check& check)
{
  LevelOfDetail detail;
  for (const std::uint32_t tetrahedra : { 0u, 1u, 19999u, 20000u, 50000u, 8000000u, 4000000000u })
  {
    const std::string name = std::to_string(tetrahedra) + " tetrahedra: ";
    detail.Reset(tetrahedra, 1e-7);
    check.Equal(detail.Choose(1e9), 0, name + "full detail without a limit");
    const int last = detail.Choose(0.0);
    check.Equal(detail.GetPixelStride(0), 1, name + "resolution of full detail");
    check.Equal(detail.GetPixelStride(1), 2, name + "half the resolution");
    check.Equal(detail.GetPixelStride(last), 4, name + "a quarter of the resolution");
    check.Equal(detail.GetSubsetSize(0), 0, name + "no subset in full detail");
    for (int level = 1; level <= last; ++level)
    {
      check.That(detail.GetExpectedSeconds(level) <= detail.GetExpectedSeconds(level - 1),
        name + "levels get faster");
      const std::uint32_t size = detail.GetSubsetSize(level);
      check.That(size == 0 ||
          (size >= LevelOfDetail::MINIMUM_SUBSET && size <= LevelOfDetail::MAXIMUM_SUBSET),
        name + "size of a subset");
    }
  }
  // Before any measurement, the level follows from an estimate.
  detail.Reset(8000000, 1e-7);
  const int first = detail.Choose(0.2);
  check.That(first > 1 && detail.GetExpectedSeconds(first) <= 0.05 &&
      detail.GetExpectedSeconds(first - 1) > 0.05,
    "the first subset leaves time to build it");
  // A time that fits retains the level, although a finer level would barely fit as well.
  detail.AddMeasurement(first, 0.15);
  check.Equal(detail.Choose(0.2), first, "no change within the margin");
  detail.AddMeasurement(first, 0.002);
  detail.AddMeasurement(first, 0.002);
  check.That(detail.Choose(0.2) < first, "finer if there is time");
  detail.AddMeasurement(0, 5.0);
  check.Equal(detail.Choose(500.0), 0, "full detail at rest");
  check.That(detail.Choose(0.2) > 0, "reduced again");
}

void CheckNewMeshes(Check& check)
{
  constexpr std::uint32_t tetrahedra = 100000;
  LevelOfDetail detail;
  detail.Reset(tetrahedra, 1e-7);
  detail.AddMeasurement(0, 10.0);
  detail.AddMeasurement(2, 3.0);
  for (const std::uint32_t factor : { 1u, 2u, 3u })
  {
    detail.ReplaceMesh(factor * tetrahedra);
    detail.ReplaceMesh(tetrahedra);
    const std::string name = "after " + std::to_string(factor) + " times as many: ";
    check.Near(detail.GetExpectedSeconds(0), 10.0, 1e-9, name + "full detail");
    check.Near(detail.GetExpectedSeconds(2), 3.0, 1e-9, name + "subset");
  }
  detail.ReplaceMesh(2 * tetrahedra);
  check.Near(detail.GetExpectedSeconds(0), 20.0, 1e-9, "time per tetrahedron");
  detail.ReplaceMesh(20 * tetrahedra);
  check.Near(detail.GetExpectedSeconds(0), 0.4, 1e-6, "estimate after a large change");

  // A mesh with fewer levels.
  detail.Reset(tetrahedra, 1e-7);
  const int last = detail.Choose(0.0);
  detail.AddMeasurement(last, 1.0);
  detail.ReplaceMesh(tetrahedra / 3);
  const int newLast = detail.Choose(0.0);
  check.That(newLast < last, "fewer levels");
  check.That(detail.GetExpectedSeconds(newLast) > 0.3, "the time of a level that does not exist");
}
}

int TestTetrahedraSubset(int, char*[])
{
  return RunChecks({ CheckSums, CheckNesting, CheckAll, CheckValues, CheckArea, CheckOddMeshes,
    CheckOrder, CheckThreads, CheckLevels, CheckNewMeshes });
}
