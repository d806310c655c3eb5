// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/SurfaceCuts.h"

#include "Common/ArrayMatch.h"
#include "Numerics/BracketedRoot.h"
#include "Volumes/ParameterSeams.h"
#include "Volumes/SimplexPoints.h"
#include "Volumes/SurfaceLevels.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkFlowStatus.h"
#include "vtkIdTypeArray.h"
#include "vtkIntervalVolume.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

namespace interlume
{

namespace
{
constexpr const char* LevelItems = "LevelItem";

// Identifies an extracted point by the ends of its edge, its position on the edge, and its
// parameters, which depend on unwrapping.
using Key = std::tuple<vtkIdType, vtkIdType, double, double, double>;

// Makes keys from the origins and parameters of the points of a mesh.
class Keys
{
public:
  explicit Keys(vtkUnstructuredGrid* mesh)
    : Ends(vtkIdTypeArray::SafeDownCast(mesh->GetPointData()->GetArray("OriginPoints")))
    , Weights(vtkDoubleArray::SafeDownCast(mesh->GetPointData()->GetArray("OriginWeight")))
    , Parameters(mesh->GetPointData()->GetArray(vtkFlowStatus::ParametersArray()))
  {
  }
  vtkIdType GetEnd(vtkIdType point, int end) const
  {
    return this->Ends->GetTypedComponent(point, end);
  }
  bool IsEdge(vtkIdType point) const { return this->GetEnd(point, 0) != this->GetEnd(point, 1); }
  Key Make(vtkIdType point, vtkIdType first, vtkIdType second) const
  {
    return { first, second, this->Weights->GetValue(point),
      this->Parameters->GetComponent(point, 0), this->Parameters->GetComponent(point, 1) };
  }

private:
  vtkSmartPointer<vtkIdTypeArray> Ends;
  vtkSmartPointer<vtkDoubleArray> Weights;
  vtkSmartPointer<vtkDataArray> Parameters;
};

void Rename(vtkUnstructuredGrid* mesh, const char* before, const char* after)
{
  vtkDataArray* array = mesh->GetCellData()->GetArray(before);
  vtkSmartPointer<vtkDataArray> renamed = vtk::TakeSmartPointer(array->NewInstance());
  renamed->ShallowCopy(array);
  renamed->SetName(after);
  mesh->GetCellData()->RemoveArray(before);
  mesh->GetCellData()->AddArray(renamed);
}

// Copies the first \a number tuples of \a first to \a all, and appends the tuples \a ids of the
// corresponding arrays of \a second.
void Append(vtkDataSetAttributes* first, vtkIdType number, vtkDataSetAttributes* second,
  const std::vector<vtkIdType>& ids, vtkDataSetAttributes* all)
{
  const auto added = static_cast<vtkIdType>(ids.size());
  all->CopyAllOn();
  all->CopyAllocate(number > 0 ? first : second, number + added);
  all->CopyData(first, 0, number, 0);
  for (int a = 0; a < all->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* array = all->GetAbstractArray(a);
    vtkAbstractArray* other = ArrayMatch::Find(all, array, second);
    array->SetNumberOfTuples(number + added);
    for (vtkIdType i = 0; i < added; ++i)
    {
      if (other)
      {
        array->SetTuple(number + i, ids[static_cast<std::size_t>(i)], other);
      }
      else if (auto* numbers = vtkDataArray::SafeDownCast(array))
      {
        std::vector<double> zero(static_cast<std::size_t>(numbers->GetNumberOfComponents()), 0.0);
        numbers->SetTuple(number + i, zero.data());
      }
    }
  }
}

// Returns the fraction of the edge from \a a to \a b at which the distance from the surface is 0,
// computed from the distances and gradients at both ends. The distance at \a a must be positive.
double FindZero(vtkUnstructuredGrid* uncut, vtkIdType a, vtkIdType b)
{
  vtkDataArray* gaps = uncut->GetPointData()->GetArray(interlume::CutGrid::GapArray());
  vtkDataArray* gradients = uncut->GetPointData()->GetArray(interlume::CutGrid::GradientArray());
  double start[3];
  double end[3];
  uncut->GetPoint(a, start);
  uncut->GetPoint(b, end);
  const double edge[3] = { end[0] - start[0], end[1] - start[1], end[2] - start[2] };
  double slope[2];
  double gradient[3];
  gradients->GetTuple(a, gradient);
  slope[0] = vtkMath::Dot(gradient, edge);
  gradients->GetTuple(b, gradient);
  slope[1] = vtkMath::Dot(gradient, edge);
  const double above = gaps->GetComponent(a, 0);
  const double below = gaps->GetComponent(b, 0);
  if (slope[0] == 0.0 && slope[1] == 0.0)
  {
    // Without gradients, interpolate linearly.
    return above / (above - below);
  }
  // Cubic Hermite interpolation of the distance along the edge.
  const auto distance = [&](double s)
  {
    const double r = 1.0 - s;
    return r * r * ((1.0 + 2.0 * s) * above + s * slope[0]) +
      s * s * ((1.0 + 2.0 * r) * below - r * slope[1]);
  };
  return BracketedRoot::Find(distance, 0.0, above, 1.0, below);
}

// Moves points on the surface from the zero of the linearly interpolated distance to the zero of
// the distance interpolated with gradients. NearTime must be 0 there, so its interpolated value is
// subtracted from AdvectionTime.
void CorrectPoints(vtkUnstructuredGrid* uncut, vtkUnstructuredGrid* cut)
{
  const Keys keys(cut);
  vtkPointData* from = uncut->GetPointData();
  vtkPointData* to = cut->GetPointData();
  vtkDataArray* gaps = from->GetArray(interlume::CutGrid::GapArray());
  vtkDataArray* times = to->GetArray(vtkFlowStatus::TimeArray());
  vtkDataArray* nearTimes = to->GetArray(interlume::CutGrid::NearTimeArray());
  std::vector<std::pair<vtkDataArray*, vtkDataArray*>> arrays{ { uncut->GetPoints()->GetData(),
    cut->GetPoints()->GetData() } };
  for (int i = 0; i < to->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = to->GetArray(i);
    vtkDataArray* before =
      array ? vtkDataArray::SafeDownCast(ArrayMatch::Find(to, array, from)) : nullptr;
    if (before && before->GetNumberOfComponents() == array->GetNumberOfComponents())
    {
      arrays.emplace_back(before, array);
    }
  }
  for (vtkIdType p = 0; p < cut->GetNumberOfPoints(); ++p)
  {
    if (!keys.IsEdge(p))
    {
      continue;
    }
    vtkIdType a = keys.GetEnd(p, 0);
    vtkIdType b = keys.GetEnd(p, 1);
    if (gaps->GetComponent(a, 0) < 0.0)
    {
      std::swap(a, b);
    }
    const double position = FindZero(uncut, a, b);
    for (const auto& array : arrays)
    {
      for (int c = 0; c < array.second->GetNumberOfComponents(); ++c)
      {
        const double start = array.first->GetComponent(a, c);
        const double end = array.first->GetComponent(b, c);
        array.second->SetComponent(p, c, start + position * (end - start));
      }
    }
    times->SetComponent(p, 0, times->GetComponent(p, 0) - nearTimes->GetComponent(p, 0));
  }
}
}

/// Keys of the points of the cut mesh. A key is known if its point lies between two input points
/// and was not created by the cut.
struct SurfaceCuts::Origins
{
  std::vector<Key> Known;
  std::vector<bool> IsKnown;
};

void SurfaceCuts::RemoveOrigins(vtkUnstructuredGrid* mesh)
{
  mesh->GetPointData()->RemoveArray("OriginPoints");
  mesh->GetPointData()->RemoveArray("OriginWeight");
  mesh->GetCellData()->RemoveArray("OriginCell");
}

vtkIdType SurfaceCuts::Prepare(vtkDataSet* input, const ImplicitFlowArrays& arrays,
  const InterpolableCells& cells, const InterpolableCells::Limits& limits)
{
  vtkIdType number = 0;
  this->Grid = this->CutGrid.Make(input, arrays, cells, number);
  if (!this->Grid)
  {
    return 0;
  }
  this->Arrays = ImplicitFlowArrays();
  // This cannot fail, because the arrays of the grid are copies of valid arrays.
  static_cast<void>(this->Arrays.Find(this->Grid));
  this->Cells.Find(this->Grid, this->Arrays, limits, nullptr, 0.0, 1.0);
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  for (vtkIdType cell = 0; cell < this->Grid->GetNumberOfCells(); ++cell)
  {
    const bool isOut = this->Cells.GetKind(cell) & InterpolableCells::EXCLUDED;
    ghosts->InsertNextValue(
      static_cast<unsigned char>(isOut ? vtkDataSetAttributes::HIDDENCELL : 0));
  }
  this->Grid->GetCellData()->AddArray(ghosts);
  this->Grid->GetPointData()->RemoveArray(vtkFlowStatus::StatusArray());
  return number;
}

vtkSmartPointer<vtkUnstructuredGrid> SurfaceCuts::Extract(const Request& request, Origins& origins)
{
  vtkNew<vtkIntervalVolume> byLevels;
  byLevels->SetInputData(this->Grid);
  byLevels->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, request.Scalars);
  byLevels->SetOutputPointsPrecision(request.Precision);
  byLevels->SetGenerateBoundaries(request.GenerateTriangles);
  byLevels->GenerateOriginArraysOn();
  byLevels->WarnOnEmptyOutputOff();
  byLevels->SetSizeWarningLimit(0);
  request.Levels->SetItems(byLevels);
  byLevels->Update();
  vtkNew<vtkUnstructuredGrid> uncut;
  uncut->ShallowCopy(byLevels->GetOutput());
  vtkNew<vtkUnstructuredGrid> boundary;
  boundary->ShallowCopy(byLevels->GetOutput(1));
  if (uncut->GetNumberOfCells() == 0)
  {
    return nullptr;
  }
  this->PointsOnSeams = this->Cells.Count(InterpolableCells::ACROSS) > 0
    ? ParameterSeams::Unwrap(this->Cells, this->Arrays, uncut, boundary)
    : 0;
  if (request.GenerateTriangles)
  {
    this->Triangles.Take(boundary, *request.Levels);
  }
  const Keys keys(uncut);
  RemoveOrigins(uncut);
  Rename(uncut, "IntervalId", LevelItems);
  vtkNew<vtkIntervalVolume> byGap;
  byGap->SetInputData(uncut);
  byGap->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, interlume::CutGrid::GapArray());
  byGap->SetInterval(0, 0.0, VTK_DOUBLE_MAX);
  byGap->GenerateOriginArraysOn();
  byGap->WarnOnEmptyOutputOff();
  byGap->SetSizeWarningLimit(0);
  byGap->Update();
  auto cut = vtkSmartPointer<vtkUnstructuredGrid>::New();
  cut->ShallowCopy(byGap->GetOutput());
  this->Triangles.Cut(uncut, cut);
  if (cut->GetNumberOfCells() == 0)
  {
    return nullptr;
  }
  CorrectPoints(uncut, cut);
  const Keys ends(cut);
  for (vtkIdType p = 0; p < cut->GetNumberOfPoints(); ++p)
  {
    const vtkIdType point = ends.GetEnd(p, 0);
    const vtkIdType first = this->CutGrid.GetInputPoint(keys.GetEnd(point, 0));
    const vtkIdType second = this->CutGrid.GetInputPoint(keys.GetEnd(point, 1));
    const bool isKnown = !ends.IsEdge(p) && first >= 0 && second >= 0;
    origins.IsKnown.push_back(isKnown);
    origins.Known.push_back(isKnown ? keys.Make(point, first, second) : Key());
  }
  RemoveOrigins(cut);
  for (const char* name : { interlume::CutGrid::GapArray(), interlume::CutGrid::GradientArray(),
         interlume::CutGrid::NearTimeArray(), interlume::CutGrid::IdArray() })
  {
    cut->GetPointData()->RemoveArray(name);
  }
  cut->GetCellData()->RemoveArray("IntervalId");
  Rename(cut, LevelItems, "IntervalId");
  return cut;
}

std::vector<vtkIdType> SurfaceCuts::FindIds(
  vtkUnstructuredGrid* mesh, const Origins& origins, std::vector<vtkIdType>& added)
{
  const vtkIdType before = mesh->GetNumberOfPoints();
  std::map<Key, vtkIdType> known;
  for (std::size_t p = 0; p < origins.Known.size(); ++p)
  {
    if (origins.IsKnown[p])
    {
      known.emplace(origins.Known[p], -1);
    }
  }
  if (before > 0)
  {
    std::vector<vtkIdType> ends;
    for (const auto& entry : known)
    {
      ends.push_back(std::get<0>(entry.first));
    }
    const Keys keys(mesh);
    for (vtkIdType p = before - 1; p >= 0; --p)
    {
      const vtkIdType first = keys.GetEnd(p, 0);
      if (std::binary_search(ends.begin(), ends.end(), first))
      {
        const auto found = known.find(keys.Make(p, first, keys.GetEnd(p, 1)));
        if (found != known.end())
        {
          found->second = p;
        }
      }
    }
  }
  std::vector<vtkIdType> ids(origins.Known.size());
  for (std::size_t p = 0; p < ids.size(); ++p)
  {
    const vtkIdType same = origins.IsKnown[p] ? known[origins.Known[p]] : -1;
    ids[p] = same >= 0 ? same : before + static_cast<vtkIdType>(added.size());
    if (same < 0)
    {
      added.push_back(static_cast<vtkIdType>(p));
    }
    if (origins.IsKnown[p])
    {
      // Cells cut at a surface and cells cut at the boundary of the reached region may share the
      // point.
      known[origins.Known[p]] = ids[p];
    }
  }
  return ids;
}

vtkSmartPointer<vtkUnstructuredGrid> SurfaceCuts::Join(
  const Request& request, vtkUnstructuredGrid* mesh)
{
  this->Triangles = SurfaceTriangles();
  this->PointsOnSeams = 0;
  Origins origins;
  const vtkSmartPointer<vtkUnstructuredGrid> cut = this->Extract(request, origins);
  if (!cut)
  {
    return mesh;
  }
  const vtkIdType before = mesh->GetNumberOfPoints();
  std::vector<vtkIdType> added;
  const std::vector<vtkIdType> ids = FindIds(mesh, origins, added);
  auto joined = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  vtkUnstructuredGrid* const like = before > 0 ? mesh : cut.GetPointer();
  points->SetDataType(like->GetPoints()->GetDataType());
  points->SetNumberOfPoints(before + static_cast<vtkIdType>(added.size()));
  for (vtkIdType p = 0; p < points->GetNumberOfPoints(); ++p)
  {
    points->SetPoint(p,
      p < before ? mesh->GetPoint(p) : cut->GetPoint(added[static_cast<std::size_t>(p - before)]));
  }
  joined->SetPoints(points);
  Append(mesh->GetPointData(), before, cut->GetPointData(), added, joined->GetPointData());
  vtkNew<vtkCellArray> cells;
  const vtkIdType numberOfCells = mesh->GetNumberOfCells() + cut->GetNumberOfCells();
  if (std::max(points->GetNumberOfPoints(), 4 * numberOfCells) <= VTK_INT_MAX)
  {
    cells->Use32BitStorage();
  }
  cells->AllocateExact(numberOfCells, 4 * numberOfCells);
  const auto add = [&cells](vtkUnstructuredGrid* grid, const auto& getId)
  {
    const SimplexPoints simplices(grid, 4);
    for (vtkIdType t = 0; t < simplices.GetNumber(); ++t)
    {
      std::array<vtkIdType, 4> corners{};
      for (int corner = 0; corner < 4; ++corner)
      {
        corners[static_cast<std::size_t>(corner)] = getId(simplices.Get(t, corner));
      }
      cells->InsertNextCell(4, corners.data());
    }
  };
  add(mesh, [](vtkIdType p) { return p; });
  add(cut, [&ids](vtkIdType p) { return ids[static_cast<std::size_t>(p)]; });
  joined->SetCells(VTK_TETRA, cells);
  std::vector<vtkIdType> tetrahedra(static_cast<std::size_t>(cut->GetNumberOfCells()));
  std::iota(tetrahedra.begin(), tetrahedra.end(), 0);
  Append(mesh->GetCellData(), mesh->GetNumberOfCells(), cut->GetCellData(), tetrahedra,
    joined->GetCellData());
  RemoveOrigins(joined);
  joined->GetFieldData()->ShallowCopy(mesh->GetFieldData());
  this->Triangles.Renumber(ids);
  return joined;
}

}
