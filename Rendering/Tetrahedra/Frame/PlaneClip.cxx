// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/PlaneClip.h"

#include "Common/ParallelFor.h"
#include "Common/Vectors.h"

#include <algorithm>
#include <iterator>
#include <limits>

namespace interlume
{

namespace
{
/// Points within this distance of a plane are treated as lying on it. Mesh coordinates are between
/// -1 and 1.
constexpr double ON_PLANE = 1e-12;

constexpr std::uint32_t RETAINED = std::numeric_limits<std::uint32_t>::max();
constexpr std::uint32_t DROPPED = RETAINED - 1;
constexpr std::uint32_t CUT = RETAINED - 2;

/// Number of planes that have their own bit in the masks of Classify().
constexpr std::size_t BITS = 31;

// Returns a value whose sign depends on the side of the plane through a, b and c on which p lies.
double GetSide(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& p)
{
  return glm::dot(p - a, glm::cross(b - a, c - a));
}

// Returns true if the face opposite p[0] separates the camera from p[0].
bool IsBehindFace(const std::array<glm::dvec3, 4>& p, const Viewpoint& view)
{
  const double cameraSide = view.IsParallel
    ? -glm::dot(view.Direction, glm::cross(p[2] - p[1], p[3] - p[1]))
    : GetSide(p[1], p[2], p[3], view.Eye);
  return cameraSide * GetSide(p[1], p[2], p[3], p[0]) < 0.0;
}
}

void PlaneClip::Append(TetrahedraMesh& mesh, TetrahedraFields& fields,
  const std::vector<Plane>& planes, const Viewpoint& view, const std::vector<std::uint32_t>* order)
{
  this->NumberClipped = 0;
  this->Points = mesh.Points.size() / 3;
  this->Tetrahedra = mesh.GetNumberOfTetrahedra();
  this->Originals.clear();
  this->Planes.clear();
  std::copy_if(planes.begin(), planes.end(), std::back_inserter(this->Planes),
    [&mesh](const Plane& plane) { return mesh.HasPointBehind(plane, ON_PLANE); });
  if (this->IsActive())
  {
    this->Classify(mesh);
    this->CutTetrahedra(mesh, fields, order ? &view : nullptr);
    this->BuildOrder(order);
  }
}

void PlaneClip::Classify(const TetrahedraMesh& mesh)
{
  // All planes after the first BITS share the last bit, which never drops a tetrahedron.
  std::vector<std::uint32_t> outside(this->Points);
  ParallelFor(0, static_cast<vtkIdType>(this->Points),
    [&](vtkIdType p)
    {
      std::uint32_t bits = 0;
      for (std::size_t i = 0; i < this->Planes.size(); ++i)
      {
        const bool isOutside =
          mesh.GetDistance(this->Planes[i], static_cast<std::uint32_t>(p)) < -ON_PLANE;
        bits |= isOutside ? 1u << std::min(i, BITS) : 0u;
      }
      outside[static_cast<std::size_t>(p)] = bits;
    });
  this->States.resize(this->Tetrahedra);
  ParallelFor(0, static_cast<vtkIdType>(this->Tetrahedra),
    [&](vtkIdType t)
    {
      const std::uint32_t* corners = mesh.GetCorners(static_cast<std::uint32_t>(t));
      std::uint32_t any = 0;
      std::uint32_t all = (1u << BITS) - 1u;
      for (int k = 0; k < 4; ++k)
      {
        any |= outside[corners[k]];
        all &= outside[corners[k]];
      }
      this->States[static_cast<std::size_t>(t)] = any == 0 ? RETAINED : all != 0 ? DROPPED : CUT;
    });
}

void PlaneClip::CutTetrahedra(TetrahedraMesh& mesh, TetrahedraFields& fields, const Viewpoint* view)
{
  this->Ranges.clear();
  this->Parts.clear();
  for (std::uint32_t t = 0; t < this->Tetrahedra; ++t)
  {
    if (this->States[t] != CUT)
    {
      continue;
    }
    Part original{};
    for (unsigned int k = 0; k < 4; ++k)
    {
      original[k] = { mesh.GetCorners(t)[k], 1u << k };
    }
    const std::size_t begin = this->Parts.size();
    this->Cut(mesh, fields, view, t, original, 0);
    this->States[t] = static_cast<std::uint32_t>(this->Ranges.size());
    this->Ranges.push_back({ begin, this->Parts.size() });
    ++this->NumberClipped;
  }
}

void PlaneClip::Cut(TetrahedraMesh& mesh, TetrahedraFields& fields, const Viewpoint* view,
  std::uint32_t tetrahedron, const Part& part, std::size_t plane)
{
  std::array<double, 4> distances{};
  bool isCut = false;
  for (; plane < this->Planes.size() && !isCut; ++plane)
  {
    for (int k = 0; k < 4; ++k)
    {
      distances[k] = mesh.GetDistance(this->Planes[plane], part[k].Id);
    }
    isCut = *std::min_element(distances.begin(), distances.end()) < -ON_PLANE;
  }
  if (!isCut)
  {
    this->Parts.push_back(mesh.GetNumberOfTetrahedra());
    this->AppendPart(mesh, fields, tetrahedron, part);
    return;
  }
  const std::vector<Part> parts = Split(mesh, fields, part, distances);
  std::vector<Range> ranges;
  for (const Part& next : parts)
  {
    const std::size_t begin = this->Parts.size();
    this->Cut(mesh, fields, view, tetrahedron, next, plane);
    ranges.push_back({ begin, this->Parts.size() });
  }
  if (view && ranges.size() > 1)
  {
    this->Sort(mesh, *view, parts, ranges);
  }
}

std::vector<PlaneClip::Part> PlaneClip::Split(TetrahedraMesh& mesh, TetrahedraFields& fields,
  const Part& part, const std::array<double, 4>& distances)
{
  // Sort the corners by side: on the plane, inside, outside.
  std::array<int, 4> k{ { 0, 1, 2, 3 } };
  const auto side = [&distances](int corner) {
    return distances[corner] > ON_PLANE ? 1 : distances[corner] < -ON_PLANE ? 2 : 0;
  };
  std::stable_sort(k.begin(), k.end(), [&side](int a, int b) { return side(a) < side(b); });
  const auto inside =
    4 - std::count_if(k.begin(), k.end(), [&side](int c) { return side(c) == 2; });
  if (inside == 0 || side(k[inside - 1]) == 0)
  {
    return {};
  }
  const auto corner = [&](int i) { return part[k[i]]; };
  const auto cut = [&](int i, int j)
  {
    if (side(k[i]) == 0)
    {
      return corner(i);
    }
    const double fraction = distances[k[i]] / (distances[k[i]] - distances[k[j]]);
    AppendPoint(mesh, fields, corner(i).Id, corner(j).Id, fraction);
    return Corner{ static_cast<std::uint32_t>(mesh.Points.size() / 3 - 1),
      corner(i).Support | corner(j).Support };
  };
  if (inside == 1)
  {
    return { { { corner(0), cut(0, 1), cut(0, 2), cut(0, 3) } } };
  }
  // The remaining part is a wedge: two triangles joined by three edges.
  std::array<Corner, 6> w;
  if (inside == 3)
  {
    w = { { corner(0), corner(1), corner(2), cut(0, 3), cut(1, 3), cut(2, 3) } };
  }
  else
  {
    w = { { corner(0), cut(0, 2), cut(0, 3), corner(1), cut(1, 2), cut(1, 3) } };
  }
  // If corners are on the plane, the first tetrahedra of the wedge have no volume. Skip them.
  const auto onPlane = std::count_if(k.begin(), k.end(), [&side](int c) { return side(c) == 0; });
  std::vector<Part> parts;
  for (auto first = static_cast<std::size_t>(inside == 3 ? onPlane : 2 * onPlane); first < 3;
       ++first)
  {
    parts.push_back({ { w[first], w[first + 1], w[first + 2], w[first + 3] } });
  }
  return parts;
}

void PlaneClip::Sort(const TetrahedraMesh& mesh, const Viewpoint& view,
  const std::vector<Part>& parts, const std::vector<Range>& ranges)
{
  // Successive parts share a face. The next part is in front if the camera is on its side of this
  // face. A view ray from the first to the third part passes through the second, so these pairs
  // determine the order of all parts.
  std::vector<std::size_t> order{ 0 };
  for (std::size_t i = 1; i < parts.size(); ++i)
  {
    std::array<glm::dvec3, 4> p{};
    for (int k = 0; k < 4; ++k)
    {
      p[k] = glm::make_vec3(mesh.GetPoint(parts[i - 1][k].Id));
    }
    const auto before = std::find(order.begin(), order.end(), i - 1);
    order.insert(IsBehindFace(p, view) ? before : order.end(), i);
  }
  const std::size_t begin = ranges.front().Begin;
  const std::vector<std::uint32_t> unsorted(
    this->Parts.begin() + static_cast<std::ptrdiff_t>(begin), this->Parts.end());
  auto to = this->Parts.begin() + static_cast<std::ptrdiff_t>(begin);
  for (std::size_t i : order)
  {
    to = std::copy(unsorted.begin() + static_cast<std::ptrdiff_t>(ranges[i].Begin - begin),
      unsorted.begin() + static_cast<std::ptrdiff_t>(ranges[i].End - begin), to);
  }
}

void PlaneClip::BuildOrder(const std::vector<std::uint32_t>* order)
{
  this->Order.clear();
  const std::size_t number = order ? order->size() : this->Tetrahedra;
  for (std::size_t i = 0; i < number; ++i)
  {
    const std::uint32_t tetrahedron = order ? (*order)[i] : static_cast<std::uint32_t>(i);
    const std::uint32_t state = this->States[tetrahedron];
    if (state == RETAINED)
    {
      this->Order.push_back(tetrahedron);
    }
    else if (state != DROPPED)
    {
      const Range& range = this->Ranges[state];
      this->Order.insert(this->Order.end(),
        this->Parts.begin() + static_cast<std::ptrdiff_t>(range.Begin),
        this->Parts.begin() + static_cast<std::ptrdiff_t>(range.End));
    }
  }
}

void PlaneClip::AppendPart(
  TetrahedraMesh& mesh, TetrahedraFields& fields, std::uint32_t tetrahedron, const Part& part)
{
  for (const Corner& corner : part)
  {
    mesh.Corners.push_back(corner.Id);
  }
  this->Originals.push_back(tetrahedron);
  if (!mesh.Cells.empty())
  {
    mesh.Cells.push_back(mesh.Cells[tetrahedron]);
  }
  if (!fields.Layers.empty())
  {
    fields.Layers.push_back(fields.Layers[tetrahedron]);
  }
  if (fields.Kind == TetrahedraFields::CELL_COLORS)
  {
    fields.Colors.push_back(fields.Colors[tetrahedron]);
  }
  if (!fields.Faces.empty())
  {
    // A face of the part lies in original face k if none of its corners depends on corner k.
    unsigned int faces = 0;
    std::array<unsigned char, 4> materials{ { 0, 0, 0, 0 } };
    for (int face = 0; face < 4; ++face)
    {
      unsigned int support = 0;
      for (int k = 0; k < 4; ++k)
      {
        support |= k == face ? 0u : part[k].Support;
      }
      const unsigned int original = fields.Faces[tetrahedron] & ~support & 15u;
      faces |= original ? 1u << face : 0u;
      for (int k = 0; k < 4 && !fields.FaceMaterials.empty(); ++k)
      {
        materials[face] =
          (original >> k) & 1u ? fields.FaceMaterials[tetrahedron][k] : materials[face];
      }
    }
    fields.Faces.push_back(static_cast<unsigned char>(faces));
    if (!fields.FaceMaterials.empty())
    {
      fields.FaceMaterials.push_back(materials);
    }
  }
}

void PlaneClip::AppendPoint(
  TetrahedraMesh& mesh, TetrahedraFields& fields, std::uint32_t a, std::uint32_t b, double fraction)
{
  for (int i = 0; i < 3; ++i)
  {
    const double from = mesh.GetPoint(a)[i];
    mesh.Points.push_back(from + fraction * (mesh.GetPoint(b)[i] - from));
  }
  const auto t = static_cast<float>(fraction);
  for (std::vector<float>* values : { &fields.Scalars, &fields.DeltaT })
  {
    if (!values->empty())
    {
      values->push_back((*values)[a] + t * ((*values)[b] - (*values)[a]));
    }
  }
  const auto append = [a, b, t](auto& values)
  {
    if (!values.empty())
    {
      auto value = values[a];
      for (std::size_t i = 0; i < value.size(); ++i)
      {
        value[i] += t * (values[b][i] - value[i]);
      }
      values.push_back(value);
    }
  };
  if (fields.Kind == TetrahedraFields::POINT_COLORS)
  {
    append(fields.Colors);
  }
  append(fields.Normals);
  append(fields.TextureCoordinates);
}

void PlaneClip::Remove(TetrahedraMesh& mesh, TetrahedraFields& fields)
{
  if (!this->IsActive())
  {
    return;
  }
  const auto shorten = [](auto& values, std::size_t size)
  {
    if (values.size() > size)
    {
      values.resize(size);
    }
  };
  this->Planes.clear();
  mesh.Points.resize(3 * this->Points);
  mesh.Corners.resize(4 * static_cast<std::size_t>(this->Tetrahedra));
  shorten(mesh.Cells, this->Tetrahedra);
  shorten(fields.Layers, this->Tetrahedra);
  shorten(fields.Faces, this->Tetrahedra);
  shorten(fields.FaceMaterials, this->Tetrahedra);
  shorten(fields.Normals, this->Points);
  shorten(fields.TextureCoordinates, this->Points);
  shorten(fields.Scalars, this->Points);
  shorten(fields.DeltaT, this->Points);
  shorten(
    fields.Colors, fields.Kind == TetrahedraFields::CELL_COLORS ? this->Tetrahedra : this->Points);
}

}
