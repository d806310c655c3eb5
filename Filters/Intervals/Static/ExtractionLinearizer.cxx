// SPDX-License-Identifier: BSD-3-Clause
#include "Static/ExtractionLinearizer.h"

#include "Arrays/PointArrays.h"
#include "Common/ArrayMatch.h"
#include "Common/GlobalIds.h"
#include "Common/GridCells.h"
#include "Common/Vectors.h"
#include "Grid/CellCorners.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <utility>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include <glm/matrix.hpp>

namespace interlume
{

namespace
{
using Face = std::vector<vtkIdType>;

class Linearizer
{
public:
  Linearizer(vtkDataSet* input, std::vector<vtkIdType>& cellIds)
    : Input(input)
    , CellIds(cellIds)
    , Order(GlobalIds::Get(input->GetPointData()))
  {
  }

  vtkSmartPointer<vtkUnstructuredGrid> Execute()
  {
    const vtkIdType cells = this->Input->GetNumberOfCells();
    this->Output->Allocate(cells);
    vtkNew<vtkIdList> points;
    for (vtkIdType cell = 0; cell < cells; ++cell)
    {
      const int type = this->Input->GetCellType(cell);
      if (CellCorners::Of(type).Kind == CellCorners::POLYHEDRAL)
      {
        this->AddPolyhedron(cell, this->GetFaces(cell, type));
      }
      else
      {
        this->Input->GetCellPoints(cell, points);
        this->AddCell(cell, type, Face(points->begin(), points->end()));
      }
    }
    this->AddPoints();
    return this->Output.GetPointer();
  }

  vtkIdType GetNumberOfConcave() const { return this->NumberOfConcave; }

private:
  std::vector<Face> GetFaces(vtkIdType cell, int type)
  {
    std::vector<Face> faces;
    vtkUnstructuredGrid* grid = vtkUnstructuredGrid::SafeDownCast(this->Input);
    if (type == VTK_POLYHEDRON && grid)
    {
      vtkNew<vtkIdList> stream;
      grid->GetFaceStream(cell, stream);
      vtkIdType at = 1;
      for (vtkIdType f = 0; f < stream->GetId(0); ++f)
      {
        const vtkIdType* first = stream->GetPointer(at + 1);
        faces.emplace_back(first, first + stream->GetId(at));
        at += 1 + stream->GetId(at);
      }
    }
    else
    {
      this->Input->GetCell(cell, this->Generic);
      for (int f = 0; f < this->Generic->GetNumberOfFaces(); ++f)
      {
        vtkIdList* ids = this->Generic->GetFace(f)->GetPointIds();
        faces.emplace_back(ids->begin(), ids->end());
      }
    }
    faces.erase(
      std::remove_if(faces.begin(), faces.end(), [](const Face& face) { return face.size() < 3; }),
      faces.end());
    return faces;
  }

  void AddCell(vtkIdType cell, int type, const Face& points)
  {
    this->Output->InsertNextCell(type, static_cast<vtkIdType>(points.size()), points.data());
    this->CellIds.push_back(cell);
  }

  // Returns the edge neighbor of \a point that is not in \a face, or -1 unless there is exactly
  // one.
  static vtkIdType GetNeighborOff(
    const std::map<vtkIdType, std::set<vtkIdType>>& neighbors, vtkIdType point, const Face& face)
  {
    vtkIdType found = -1;
    for (vtkIdType other : neighbors.at(point))
    {
      if (std::find(face.begin(), face.end(), other) == face.end())
      {
        if (found >= 0)
        {
          return -1;
        }
        found = other;
      }
    }
    return found;
  }

  // If the polyhedron has the faces of a cell with an isotable, sets \a type to the type of that
  // cell and returns the points in the order of that type. Otherwise returns no points.
  static Face Recognize(const std::vector<Face>& faces, int& type)
  {
    std::map<vtkIdType, std::set<vtkIdType>> neighbors;
    int triangles = 0;
    int quadrilaterals = 0;
    for (const Face& face : faces)
    {
      triangles += face.size() == 3;
      quadrilaterals += face.size() == 4;
      for (std::size_t i = 0; i < face.size(); ++i)
      {
        const vtkIdType a = face[i];
        const vtkIdType b = face[(i + 1) % face.size()];
        neighbors[a].insert(b);
        neighbors[b].insert(a);
      }
    }
    struct Pattern
    {
      int Points, Triangles, Quadrilaterals, Type;
      std::size_t Base;
    };
    static const Pattern patterns[] = { { 4, 4, 0, VTK_TETRA, 3 }, { 5, 4, 1, VTK_PYRAMID, 4 },
      { 6, 2, 3, VTK_WEDGE, 3 }, { 8, 0, 6, VTK_HEXAHEDRON, 4 } };
    for (const Pattern& pattern : patterns)
    {
      if (pattern.Points != static_cast<int>(neighbors.size()) || pattern.Triangles != triangles ||
        pattern.Quadrilaterals != quadrilaterals ||
        triangles + quadrilaterals != static_cast<int>(faces.size()))
      {
        continue;
      }
      type = pattern.Type;
      Face points = *std::find_if(faces.begin(), faces.end(),
        [&pattern](const Face& face) { return face.size() == pattern.Base; });
      const Face base = points;
      for (vtkIdType point : base)
      {
        const vtkIdType above = GetNeighborOff(neighbors, point, base);
        if (above < 0)
        {
          return {};
        }
        points.push_back(above);
      }
      // In a tetrahedron or pyramid, all base points have the same neighbor, the apex. Keep it
      // only once.
      points.resize(pattern.Points);
      return points;
    }
    return {};
  }

  vtkIdType GetOrder(vtkIdType point) const
  {
    return this->Order ? this->Order->GetValue(point) : point;
  }

  void AddPolyhedron(vtkIdType cell, const std::vector<Face>& faces)
  {
    int type = VTK_EMPTY_CELL;
    const Face known = Recognize(faces, type);
    if (!known.empty())
    {
      this->AddCell(cell, type, known);
      return;
    }
    Face vertices;
    for (const Face& face : faces)
    {
      vertices.insert(vertices.end(), face.begin(), face.end());
    }
    if (vertices.empty())
    {
      return;
    }
    // Sort the vertices in the global order, so that the mean is rounded identically in all pieces.
    std::sort(vertices.begin(), vertices.end(),
      [this](vtkIdType a, vtkIdType b) { return this->GetOrder(a) < this->GetOrder(b); });
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    const vtkIdType center =
      this->Input->GetNumberOfPoints() + static_cast<vtkIdType>(this->Centers.size());
    this->Centers.push_back(vertices);
    this->NumberOfConcave += !this->IsStarShaped(faces, this->Centers.back());
    for (const Face& face : faces)
    {
      if (face.size() == 4)
      {
        this->AddCell(cell, VTK_PYRAMID, { face[0], face[1], face[2], face[3], center });
        continue;
      }
      this->ForEachTriangle(face,
        [&](vtkIdType a, vtkIdType b, vtkIdType c) {
          this->AddCell(cell, VTK_TETRA, { a, b, c, center });
        });
    }
  }

  // Calls visit(a, b, c) for the triangles of a face, as a fan around its first point in the global
  // order.
  template <typename Visitor>
  void ForEachTriangle(const Face& face, Visitor&& visit) const
  {
    const auto lowest = std::min_element(face.begin(), face.end(),
      [this](vtkIdType a, vtkIdType b) { return this->GetOrder(a) < this->GetOrder(b); });
    const std::size_t start = lowest - face.begin();
    for (std::size_t i = 1; i + 1 < face.size(); ++i)
    {
      visit(*lowest, face[(start + i) % face.size()], face[(start + i + 1) % face.size()]);
    }
  }

  // Orients all faces outward or all faces inward, so that any two faces traverse their common edge
  // in opposite directions.
  static void Orient(std::vector<Face>& faces)
  {
    std::map<std::pair<vtkIdType, vtkIdType>, std::vector<std::size_t>> facesOf;
    for (std::size_t f = 0; f < faces.size(); ++f)
    {
      for (std::size_t i = 0; i < faces[f].size(); ++i)
      {
        facesOf[std::minmax({ faces[f][i], faces[f][(i + 1) % faces[f].size()] })].push_back(f);
      }
    }
    const auto hasEdge = [](const Face& face, vtkIdType a, vtkIdType b)
    {
      const auto at = std::find(face.begin(), face.end(), a);
      return at != face.end() && (at + 1 == face.end() ? face.front() : at[1]) == b;
    };
    std::vector<bool> isVisited(faces.size(), false);
    std::vector<std::size_t> next = { 0 };
    isVisited[0] = true;
    while (!next.empty())
    {
      const Face face = faces[next.back()];
      next.pop_back();
      for (std::size_t i = 0; i < face.size(); ++i)
      {
        const vtkIdType a = face[i];
        const vtkIdType b = face[(i + 1) % face.size()];
        for (const std::size_t other : facesOf[std::minmax({ a, b })])
        {
          if (!isVisited[other])
          {
            if (hasEdge(faces[other], a, b))
            {
              std::reverse(faces[other].begin(), faces[other].end());
            }
            isVisited[other] = true;
            next.push_back(other);
          }
        }
      }
    }
  }

  // Returns whether a polyhedron is star-shaped around the mean of its vertices.
  bool IsStarShaped(std::vector<Face> faces, const Face& vertices) const
  {
    const glm::dvec3 center = this->GetMeanPoint(vertices);
    if (!Vectors::IsFinite(center))
    {
      // The extraction skips this polyhedron.
      return true;
    }
    Orient(faces);
    double inside = 0.0;
    double outside = 0.0;
    double size = 0.0;
    for (const Face& face : faces)
    {
      this->ForEachTriangle(face,
        [&](vtkIdType a, vtkIdType b, vtkIdType c)
        {
          const glm::dmat3 sides(
            this->GetPoint(a) - center, this->GetPoint(b) - center, this->GetPoint(c) - center);
          const double volume = glm::determinant(sides);
          (volume > 0.0 ? inside : outside) += std::abs(volume);
          size += glm::length(sides[0]) * glm::length(sides[1]) * glm::length(sides[2]);
        });
    }
    constexpr double rounding = 1e-6;
    // The volumes of a degenerate polyhedron are rounding errors.
    constexpr double flat = 1e-12;
    return std::min(inside, outside) <= std::max(rounding * (inside + outside), flat * size);
  }

  glm::dvec3 GetPoint(vtkIdType point) const
  {
    glm::dvec3 x;
    this->Input->GetPoint(point, glm::value_ptr(x));
    return x;
  }

  glm::dvec3 GetMeanPoint(const Face& vertices) const
  {
    glm::dvec3 mean(0.0);
    for (const vtkIdType vertex : vertices)
    {
      mean += this->GetPoint(vertex) / static_cast<double>(vertices.size());
    }
    return mean;
  }

  // Computes the mean of an array component over vertices. If all values are integers, their sum is
  // exact and is divided at the end, so that a mean that should equal a bound does. Otherwise each
  // term is divided, since the sum might overflow.
  double GetMean(vtkDataArray* array, const Face& vertices, int component) const
  {
    constexpr double maximumExactInteger = 4503599627370496.0; // 2^52
    const double number = static_cast<double>(vertices.size());
    double sum = 0.0;
    double integerSum = 0.0;
    double magnitude = 0.0;
    bool areIntegers = true;
    bool isConstant = true;
    const double first = array->GetComponent(vertices.front(), component);
    for (vtkIdType vertex : vertices)
    {
      const double value = array->GetComponent(vertex, component);
      sum += value / number;
      integerSum += value;
      magnitude += std::abs(value);
      areIntegers = areIntegers && value == std::floor(value);
      isConstant = isConstant && value == first;
    }
    return isConstant                                  ? first
      : areIntegers && magnitude < maximumExactInteger ? integerSum / number
                                                       : sum;
  }

  void AddPoints()
  {
    const vtkIdType before = this->Input->GetNumberOfPoints();
    const vtkIdType after = before + static_cast<vtkIdType>(this->Centers.size());
    vtkNew<vtkPoints> points;
    vtkPointSet* set = vtkPointSet::SafeDownCast(this->Input);
    points->SetDataType(
      set && set->GetPoints()->GetDataType() == VTK_FLOAT ? VTK_FLOAT : VTK_DOUBLE);
    points->SetNumberOfPoints(after);
    for (vtkIdType p = 0; p < before; ++p)
    {
      double x[3];
      this->Input->GetPoint(p, x);
      points->SetPoint(p, x);
    }
    for (vtkIdType p = before; p < after; ++p)
    {
      const glm::dvec3 mean = this->GetMeanPoint(this->Centers[p - before]);
      points->SetPoint(p, glm::value_ptr(mean));
    }
    this->Output->SetPoints(points);
    this->AddPointData(before, after);
  }

  void AddPointData(vtkIdType before, vtkIdType after)
  {
    vtkPointData* from = this->Input->GetPointData();
    vtkPointData* to = this->Output->GetPointData();
    if (this->Centers.empty())
    {
      to->ShallowCopy(from);
      return;
    }
    // Centers get mean values below; grid points keep their exact values.
    ExtractionBuffer<ExtractionPoint> same;
    same.Allocate(after);
    for (vtkIdType p = 0; p < after; ++p)
    {
      const vtkIdType source = p < before ? p : this->Centers[p - before].front();
      same[p] = { source, source, 0.0 };
    }
    PointArrays arrays(from, from, VTK_ID_MAX);
    arrays.Fill(same);
    arrays.AddTo(to);
    for (int a = 0; a < to->GetNumberOfArrays(); ++a)
    {
      vtkDataArray* array = to->GetArray(a);
      vtkDataArray* source =
        array ? vtkDataArray::SafeDownCast(ArrayMatch::Find(to, array, from)) : nullptr;
      if (source)
      {
        this->FillMeans(source, array, before);
      }
    }
    if (vtkDataArray* ids = vtkDataArray::SafeDownCast(from->GetPedigreeIds()))
    {
      // Extend the pedigree ids, since they may be the scalars of the extraction.
      const auto extended = vtk::TakeSmartPointer(ids->NewInstance());
      extended->DeepCopy(ids);
      extended->Resize(after);
      extended->SetNumberOfTuples(after);
      this->FillMeans(ids, extended, before);
      to->SetPedigreeIds(extended);
    }
    this->AddOrder(before, after);
    if (vtkUnsignedCharArray* ghosts = this->Input->GetPointGhostArray())
    {
      vtkNew<vtkUnsignedCharArray> copy;
      copy->DeepCopy(ghosts);
      copy->Resize(after);
      copy->SetNumberOfValues(after);
      std::fill_n(copy->GetPointer(before), after - before, static_cast<unsigned char>(0));
      to->AddArray(copy);
    }
  }

  // Sets the tuples of the centers, which start at index \a before, to means of the vertices.
  void FillMeans(vtkDataArray* source, vtkDataArray* array, vtkIdType before) const
  {
    for (std::size_t center = 0; center < this->Centers.size(); ++center)
    {
      for (int c = 0; c < array->GetNumberOfComponents(); ++c)
      {
        array->SetComponent(before + static_cast<vtkIdType>(center), c,
          this->GetMean(source, this->Centers[center], c));
      }
    }
  }

  // Adds global ids that place the centers after all other points.
  void AddOrder(vtkIdType before, vtkIdType after)
  {
    if (!this->Order)
    {
      return;
    }
    vtkNew<vtkIdTypeArray> ids;
    ids->SetName(this->Input->GetPointData()->GetGlobalIds()->GetName());
    ids->SetNumberOfValues(after);
    vtkIdType highest = 0;
    for (vtkIdType p = 0; p < before; ++p)
    {
      ids->SetValue(p, this->Order->GetValue(p));
      highest = std::max(highest, this->Order->GetValue(p));
    }
    std::iota(ids->GetPointer(before), ids->GetPointer(before) + (after - before), highest + 1);
    this->Output->GetPointData()->SetGlobalIds(ids);
  }

  vtkDataSet* Input;
  std::vector<vtkIdType>& CellIds;
  // Global ids of the input points, or null.
  vtkSmartPointer<GlobalIds::Array> Order;
  vtkNew<vtkUnstructuredGrid> Output;
  vtkNew<vtkGenericCell> Generic;
  // Vertices of each split polyhedron.
  std::vector<Face> Centers;
  vtkIdType NumberOfConcave = 0;
};
}

ExtractionLinearizer::TypeSet ExtractionLinearizer::FindTypes(vtkDataSet* input)
{
  TypeSet found;
  const vtkIdType number = input->GetNumberOfCells();
  vtkUnstructuredGrid* grid = vtkUnstructuredGrid::SafeDownCast(input);
  if (!grid)
  {
    for (vtkIdType cell = 0; cell < number; ++cell)
    {
      found[input->GetCellType(cell)] = true;
    }
    return found;
  }
  const auto stored = GridCells::GetTypes(grid);
  const unsigned char* types = stored->GetPointer(0);
  const vtkIdType first = number > 0 && GridCells::AreTypesEqual(types, number) ? number - 1 : 0;
  for (vtkIdType cell = first; cell < number; ++cell)
  {
    found[types[cell]] = true;
  }
  return found;
}

bool ExtractionLinearizer::IsNeeded(vtkDataSet* input)
{
  if (!vtkUnstructuredGrid::SafeDownCast(input))
  {
    return true;
  }
  const TypeSet types = FindTypes(input);
  for (int type = 0; type < 256; ++type)
  {
    if (types[type] && CellCorners::Of(type).Kind == CellCorners::POLYHEDRAL)
    {
      return true;
    }
  }
  return false;
}

vtkSmartPointer<vtkUnstructuredGrid> ExtractionLinearizer::Execute(
  vtkDataSet* input, std::vector<vtkIdType>& cellIds, vtkIdType& numberOfConcave)
{
  Linearizer linearizer(input, cellIds);
  vtkSmartPointer<vtkUnstructuredGrid> linear = linearizer.Execute();
  numberOfConcave = linearizer.GetNumberOfConcave();
  if (vtkUnsignedCharArray* ghosts = input->GetCellGhostArray())
  {
    vtkNew<vtkUnsignedCharArray> linearGhosts;
    linearGhosts->SetName(vtkDataSetAttributes::GhostArrayName());
    for (vtkIdType cell : cellIds)
    {
      linearGhosts->InsertNextValue(ghosts->GetValue(cell));
    }
    linear->GetCellData()->AddArray(linearGhosts);
  }
  return linear;
}

}
