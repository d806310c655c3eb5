// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/TetrahedraBuilder.h"

#include "Common/ArrayCheck.h"
#include "Common/ParallelFor.h"
#include "Common/ThreadLocals.h"

#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkPiecewiseFunction.h"
#include "vtkSMPTools.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace interlume
{

int TetrahedraBuilder::GetColoringComponent(vtkDataArray* scalars, vtkVolumeProperty* property)
{
  if (scalars->GetNumberOfComponents() == 1 || !property->GetIndependentComponents() ||
    property->GetColorChannels() != 3)
  {
    return 0;
  }
  vtkColorTransferFunction* colors = property->GetRGBTransferFunction();
  if (colors->GetVectorMode() == vtkScalarsToColors::MAGNITUDE)
  {
    return -1;
  }
  return std::max(0, std::min(colors->GetVectorComponent(), scalars->GetNumberOfComponents() - 1));
}

namespace
{
// Returns the scalar used for coloring: a component, or the magnitude if component is -1.
double GetValue(vtkDataArray* array, vtkIdType id, int component)
{
  if (component >= 0)
  {
    return array->GetComponent(id, component);
  }
  double sum = 0.0;
  for (int c = 0; c < array->GetNumberOfComponents(); ++c)
  {
    sum += array->GetComponent(id, c) * array->GetComponent(id, c);
  }
  return std::sqrt(sum);
}

// Returns the color and extinction of a tuple, from the transfer functions or directly from color
// components.
std::array<float, 4> GetColor(
  vtkDataArray* array, vtkIdType id, int component, vtkVolumeProperty* property, double unit)
{
  const int components = array->GetNumberOfComponents();
  const bool isColor = !property->GetIndependentComponents() && components >= 3;
  double color[3];
  double opacity = 0.0;
  if (isColor)
  {
    const double scale = array->GetDataType() == VTK_UNSIGNED_CHAR ? 1.0 / 255.0 : 1.0;
    for (int c = 0; c < 3; ++c)
    {
      color[c] = scale * array->GetComponent(id, c);
    }
    opacity = components == 4 ? array->GetComponent(id, 3)
                              : (color[0] + color[1] + color[2]) / (3.0 * scale);
  }
  else
  {
    const double value = GetValue(array, id, component);
    if (property->GetColorChannels() == 3)
    {
      property->GetRGBTransferFunction()->GetColor(value, color);
    }
    else
    {
      color[0] = color[1] = color[2] = property->GetGrayTransferFunction()->GetValue(value);
    }
    const bool isPair = !property->GetIndependentComponents() && components == 2;
    opacity = isPair ? array->GetComponent(id, 1) : value;
  }
  const double extinction = property->GetScalarOpacity()->GetValue(opacity) * unit;
  return { { static_cast<float>(color[0]), static_cast<float>(color[1]),
    static_cast<float>(color[2]), static_cast<float>(extinction) } };
}

// Sets the scalars and their range.
void BuildScalars(
  vtkDataArray* scalars, int component, std::size_t points, TetrahedraFields& fields)
{
  using Range = std::array<double, 2>;
  const auto number = static_cast<vtkIdType>(points);
  constexpr Range none = { { std::numeric_limits<double>::max(),
    std::numeric_limits<double>::lowest() } };
  Range all = none;
  ThreadLocals<std::optional<Range>> ranges;
  vtkSMPTools::For(0, number,
    [&](vtkIdType first, vtkIdType last)
    {
      std::optional<Range>& range = ranges.Local();
      range = range.value_or(none);
      for (vtkIdType p = first; p < last; ++p)
      {
        if (TetrahedraArrays::IsFinite(scalars, p))
        {
          const double value = GetValue(scalars, p, component);
          (*range)[0] = std::min((*range)[0], value);
          (*range)[1] = std::max((*range)[1], value);
        }
      }
    });
  for (const std::optional<Range>& range : ranges)
  {
    all = { { std::min(all[0], (*range)[0]), std::max(all[1], (*range)[1]) } };
  }
  std::copy(all.begin(), all.end(), fields.Range);
  fields.Scalars.resize(points);
  // Halve the values first, so that their difference cannot overflow.
  const double low = 0.5 * all[0];
  const double width = 0.5 * all[1] - low;
  if (!(width > 0.0))
  {
    return;
  }
  ParallelFor(0, number,
    [&](vtkIdType p)
    {
      const double value = GetValue(scalars, p, component);
      const double fraction = (0.5 * value - low) / width;
      fields.Scalars[p] =
        TetrahedraArrays::IsFinite(scalars, p) ? static_cast<float>(fraction) : 0.0f;
    });
}
}

void TetrahedraBuilder::BuildDeltaTAndLayers(
  const TetrahedraArrays& arrays, const TetrahedraMesh& mesh, TetrahedraFields& fields)
{
  fields.DeltaT.clear();
  fields.Layers.clear();
  const std::size_t points = mesh.Points.size() / 3;
  if (arrays.DeltaT)
  {
    fields.DeltaT.resize(points);
    ParallelFor(0, static_cast<vtkIdType>(points),
      [&](vtkIdType p)
      {
        // The value may be NaN or infinity, but then no tetrahedron of the mesh uses the point.
        fields.DeltaT[p] = static_cast<float>(arrays.DeltaT->GetComponent(p, 0));
      });
  }
  if (arrays.Layers)
  {
    fields.Layers.resize(mesh.GetNumberOfTetrahedra());
    for (std::size_t t = 0; t < fields.Layers.size(); ++t)
    {
      const std::size_t cell = mesh.Cells.empty() ? t : mesh.Cells[t];
      fields.Layers[t] =
        static_cast<int>(arrays.Layers->GetComponent(static_cast<vtkIdType>(cell), 0));
    }
  }
}

Error TetrahedraBuilder::BuildColors(const TetrahedraArrays& arrays, const TetrahedraMesh& mesh,
  vtkVolumeProperty* property, double unit, TetrahedraFields& fields)
{
  fields.Colors.clear();
  fields.Scalars.clear();
  vtkDataArray* scalars = arrays.Scalars;
  const int components = scalars->GetNumberOfComponents();
  const bool isDependent = !property->GetIndependentComponents() && components > 1;
  if (isDependent && components > 4)
  {
    return ArrayCheck::Describe(scalars) + " has " + std::to_string(components) +
      " components, but without IndependentComponents there must be 1 to 4";
  }
  const int component = GetColoringComponent(scalars, property);
  const std::size_t points = mesh.Points.size() / 3;
  if (arrays.HasCellScalars)
  {
    fields.Kind = TetrahedraFields::CELL_COLORS;
    fields.Colors.resize(mesh.GetNumberOfTetrahedra());
  }
  else if (isDependent)
  {
    fields.Kind = TetrahedraFields::POINT_COLORS;
    fields.Colors.resize(points);
  }
  else
  {
    fields.Kind = TetrahedraFields::SCALARS;
    BuildScalars(scalars, component, points, fields);
    return {};
  }
  for (std::size_t i = 0; i < fields.Colors.size(); ++i)
  {
    const std::size_t id = arrays.HasCellScalars && !mesh.Cells.empty() ? mesh.Cells[i] : i;
    if (TetrahedraArrays::IsFinite(scalars, static_cast<vtkIdType>(id)))
    {
      fields.Colors[i] = GetColor(scalars, static_cast<vtkIdType>(id), component, property, unit);
    }
  }
  return {};
}

}
