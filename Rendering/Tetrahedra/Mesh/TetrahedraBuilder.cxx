// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/TetrahedraBuilder.h"

#include "Common/ArrayCheck.h"

#include "vtkArrayDispatch.h"
#include "vtkCell.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkDataSetAttributes.h"
#include "vtkGenericCell.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace interlume
{

namespace
{
// The reasons for which a tetrahedron is left out.
enum Marks : unsigned char
{
  DRAWN,
  FLAT,
  NON_FINITE,
  GHOST
};

// Copies point ids of one storage width.
struct CornerCopier
{
  template <typename Array>
  void operator()(Array* connectivity, std::vector<std::uint32_t>& corners) const
  {
    const auto ids = vtk::DataArrayValueRange(connectivity);
    vtkSMPTools::For(0, static_cast<vtkIdType>(corners.size()),
      [&](vtkIdType first, vtkIdType last)
      {
        for (vtkIdType i = first; i < last; ++i)
        {
          corners[i] = static_cast<std::uint32_t>(ids[i]);
        }
      });
  }
};

bool IsFinite(vtkDataArray* array, vtkIdType id)
{
  for (int c = 0; c < array->GetNumberOfComponents(); ++c)
  {
    if (!std::isfinite(array->GetComponent(id, c)))
    {
      return false;
    }
  }
  return true;
}

// Sets mesh coordinates, and marks points that cannot be used.
std::vector<unsigned char> CopyPoints(
  vtkUnstructuredGrid* grid, const TetrahedraArrays& arrays, TetrahedraMesh& mesh)
{
  vtkDataArray* coordinates = grid->GetPoints()->GetData();
  const vtkIdType points = coordinates->GetNumberOfTuples();
  std::vector<unsigned char> isBad(points, 0);
  mesh.Points.resize(3 * static_cast<std::size_t>(points));
  vtkSMPTools::For(0, points,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType p = first; p < last; ++p)
      {
        for (int i = 0; i < 3; ++i)
        {
          mesh.Points[3 * p + i] = coordinates->GetComponent(p, i);
        }
        isBad[p] = !IsFinite(coordinates, p) ||
          (arrays.Scalars && !arrays.ScalarsAreOfCells && !IsFinite(arrays.Scalars, p)) ||
          (arrays.DeltaT && !IsFinite(arrays.DeltaT, p));
      }
    });
  double bounds[6] = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };
  bool isFirst = true;
  for (vtkIdType p = 0; p < points; ++p)
  {
    for (int i = 0; i < 3 && !isBad[p]; ++i)
    {
      const double x = mesh.Points[3 * p + i];
      bounds[2 * i] = isFirst ? x : std::min(bounds[2 * i], x);
      bounds[2 * i + 1] = isFirst ? x : std::max(bounds[2 * i + 1], x);
    }
    isFirst = isFirst && isBad[p];
  }
  mesh.Scale = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    mesh.Origin[i] = 0.5 * bounds[2 * i] + 0.5 * bounds[2 * i + 1];
    mesh.Scale = std::max(mesh.Scale, bounds[2 * i + 1] - mesh.Origin[i]);
  }
  mesh.Scale = mesh.Scale > 0.0 ? mesh.Scale : 1.0;
  vtkSMPTools::For(0, points,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType p = first; p < last; ++p)
      {
        for (int i = 0; i < 3; ++i)
        {
          double& x = mesh.Points[3 * p + i];
          x = isBad[p] ? 0.0 : (x - mesh.Origin[i]) / mesh.Scale;
        }
      }
    });
  return isBad;
}
}

std::string TetrahedraBuilder::BuildMesh(
  vtkUnstructuredGrid* grid, const TetrahedraArrays& arrays, TetrahedraMesh& mesh, Counts& counts)
{
  counts = Counts();
  mesh = TetrahedraMesh();
  const vtkIdType cells = grid->GetNumberOfCells();
  if (cells == 0 || !grid->GetPoints())
  {
    return {};
  }
  for (vtkIdType cell = 0; cell < cells; ++cell)
  {
    if (grid->GetCellType(cell) != VTK_TETRA)
    {
      const auto type =
        vtkSmartPointer<vtkCell>::Take(vtkGenericCell::InstantiateCell(grid->GetCellType(cell)));
      return "cell " + std::to_string(cell) + " is a " +
        (type ? type->GetClassName() : "cell of unknown type") +
        ", and only tetrahedra can be drawn; vtkDataSetTriangleFilter, vtkIntervalVolume "
        "without KeepWholeCells or vtkTetrahedralMesher make tetrahedra of it";
    }
  }
  if (std::max(cells, grid->GetNumberOfPoints()) >= std::numeric_limits<std::uint32_t>::max())
  {
    return "more than 4294967294 points or cells";
  }

  const std::vector<unsigned char> isBad = CopyPoints(grid, arrays, mesh);
  mesh.Corners.resize(4 * static_cast<std::size_t>(cells));
  const CornerCopier copier;
  vtkDataArray* connectivity = grid->GetCells()->GetConnectivityArray();
  if (!vtkArrayDispatch::DispatchByValueType<vtkArrayDispatch::Integrals>::Execute(
        connectivity, copier, mesh.Corners))
  {
    copier(connectivity, mesh.Corners);
  }

  vtkUnsignedCharArray* ghosts = vtkUnsignedCharArray::SafeDownCast(
    grid->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName()));
  std::vector<unsigned char> marks(cells, DRAWN);
  vtkSMPTools::For(0, cells,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType cell = first; cell < last; ++cell)
      {
        const std::uint32_t* corners = mesh.GetCorners(static_cast<std::uint32_t>(cell));
        const bool isGhost = ghosts &&
          (ghosts->GetValue(cell) &
            (vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::HIDDENCELL));
        if (isGhost)
        {
          marks[cell] = GHOST;
        }
        else if (isBad[corners[0]] || isBad[corners[1]] || isBad[corners[2]] || isBad[corners[3]] ||
          (arrays.Scalars && arrays.ScalarsAreOfCells && !IsFinite(arrays.Scalars, cell)))
        {
          marks[cell] = NON_FINITE;
        }
        else if (mesh.GetSixfoldVolume(static_cast<std::uint32_t>(cell)) == 0.0)
        {
          marks[cell] = FLAT;
        }
      }
    });
  counts.Flat = std::count(marks.begin(), marks.end(), FLAT);
  counts.NonFinite = std::count(marks.begin(), marks.end(), NON_FINITE);
  const vtkIdType drawn = std::count(marks.begin(), marks.end(), DRAWN);
  if (drawn < cells)
  {
    std::vector<std::uint32_t> kept;
    kept.reserve(4 * static_cast<std::size_t>(drawn));
    for (vtkIdType cell = 0; cell < cells; ++cell)
    {
      if (marks[cell] == DRAWN)
      {
        const std::uint32_t* corners = mesh.GetCorners(static_cast<std::uint32_t>(cell));
        kept.insert(kept.end(), corners, corners + 4);
        mesh.Cells.push_back(static_cast<std::uint32_t>(cell));
      }
    }
    mesh.Corners = std::move(kept);
  }
  return {};
}

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
// Returns the value that colours: a component or the magnitude.
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

// Returns colour and extinction of one tuple, by the functions or as the colour it is.
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
}

void TetrahedraBuilder::BuildFields(
  const TetrahedraArrays& arrays, const TetrahedraMesh& mesh, TetrahedraFields& fields)
{
  fields.DeltaT.clear();
  fields.Layers.clear();
  const std::size_t points = mesh.Points.size() / 3;
  if (arrays.DeltaT)
  {
    fields.DeltaT.resize(points);
    for (std::size_t p = 0; p < points; ++p)
    {
      const double extent = arrays.DeltaT->GetComponent(static_cast<vtkIdType>(p), 0);
      fields.DeltaT[p] = std::isfinite(extent) ? static_cast<float>(extent) : 0.0f;
    }
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

std::string TetrahedraBuilder::BuildColors(const TetrahedraArrays& arrays,
  const TetrahedraMesh& mesh, vtkVolumeProperty* property, double unit, TetrahedraFields& fields)
{
  fields.Colors.clear();
  fields.Scalars.clear();
  vtkDataArray* scalars = arrays.Scalars;
  const int components = scalars->GetNumberOfComponents();
  const bool isDependent = !property->GetIndependentComponents() && components > 1;
  if (isDependent && components > 4)
  {
    return ArrayCheck::Describe(scalars) + " has " + std::to_string(components) +
      " components; without IndependentComponents 1 to 4 are needed";
  }
  const int component = GetColoringComponent(scalars, property);
  const std::size_t points = mesh.Points.size() / 3;
  const auto isFinite = [&](std::size_t id)
  { return IsFinite(scalars, static_cast<vtkIdType>(id)); };
  if (arrays.ScalarsAreOfCells)
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
    fields.Scalars.resize(points);
    double& low = fields.Range[0];
    double& high = fields.Range[1];
    low = std::numeric_limits<double>::max();
    high = std::numeric_limits<double>::lowest();
    for (std::size_t p = 0; p < points; ++p)
    {
      if (isFinite(p))
      {
        const double value = GetValue(scalars, static_cast<vtkIdType>(p), component);
        low = std::min(low, value);
        high = std::max(high, value);
      }
    }
    // Values are halved, since the difference may be beyond the largest number.
    const double width = 0.5 * high - 0.5 * low;
    for (std::size_t p = 0; p < points && width > 0.0; ++p)
    {
      const double value = GetValue(scalars, static_cast<vtkIdType>(p), component);
      const double share = (0.5 * value - 0.5 * low) / width;
      fields.Scalars[p] = isFinite(p) ? static_cast<float>(share) : 0.0f;
    }
    return {};
  }
  for (std::size_t i = 0; i < fields.Colors.size(); ++i)
  {
    const std::size_t id = arrays.ScalarsAreOfCells && !mesh.Cells.empty() ? mesh.Cells[i] : i;
    if (isFinite(id))
    {
      fields.Colors[i] = GetColor(scalars, static_cast<vtkIdType>(id), component, property, unit);
    }
  }
  return {};
}

}
