// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/NearClip.h"

#include "vtkSMPTools.h"

#include <algorithm>

namespace interlume
{

namespace
{
// Returns a number that is positive on one side of the plane through a, b, c.
double GetSide(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& p)
{
  return glm::dot(p - a, glm::cross(b - a, c - a));
}
}

void NearClip::Append(TetrahedraMesh& mesh, TetrahedraFields& fields, const TetrahedraView& view,
  const std::vector<std::uint32_t>* order)
{
  this->Active = false;
  this->NumberClipped = 0;
  this->Points = mesh.Points.size() / 3;
  this->Tetrahedra = mesh.GetNumberOfTetrahedra();
  this->Wholes.clear();
  if (view.GetReach()[0] >= view.GetNear())
  {
    return;
  }
  std::vector<unsigned char> isBefore(this->Points);
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Points),
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType p = first; p < last; ++p)
      {
        isBefore[p] = -view.GetEyePoint(&mesh.Points[3 * p])[2] < view.GetNear();
      }
    });
  if (std::find(isBefore.begin(), isBefore.end(), 1) == isBefore.end())
  {
    return;
  }
  this->Active = true;
  this->Order.clear();
  const std::size_t number = order ? order->size() : this->Tetrahedra;
  for (std::size_t i = 0; i < number; ++i)
  {
    const std::uint32_t tetrahedron = order ? (*order)[i] : static_cast<std::uint32_t>(i);
    const std::uint32_t* corners = mesh.GetCorners(tetrahedron);
    const int before =
      isBefore[corners[0]] + isBefore[corners[1]] + isBefore[corners[2]] + isBefore[corners[3]];
    if (before == 0)
    {
      this->Order.push_back(tetrahedron);
    }
    else if (before < 4)
    {
      this->Cut(mesh, fields, view, tetrahedron);
      ++this->NumberClipped;
    }
  }
}

void NearClip::Cut(TetrahedraMesh& mesh, TetrahedraFields& fields, const TetrahedraView& view,
  std::uint32_t tetrahedron)
{
  // Corners beyond the plane come first.
  std::array<Corner, 4> corners;
  std::array<glm::dvec3, 4> eyes;
  int inside = 0;
  int outside = 4;
  for (int k = 0; k < 4; ++k)
  {
    const std::uint32_t id = mesh.GetCorners(tetrahedron)[k];
    const glm::dvec3 eye = view.GetEyePoint(mesh.GetPoint(id));
    const int place = -eye[2] < view.GetNear() ? --outside : inside++;
    corners[place] = { id, 1u << k };
    eyes[place] = eye;
  }
  const auto cut = [&](int a, int b)
  {
    const double share = std::min(1.0, (view.GetNear() + eyes[a][2]) / (eyes[a][2] - eyes[b][2]));
    this->AppendPoint(mesh, fields, corners[a].Id, corners[b].Id, share);
    return Corner{ static_cast<std::uint32_t>(mesh.Points.size() / 3 - 1),
      corners[a].Support | corners[b].Support };
  };
  std::vector<Part> parts;
  if (inside == 1)
  {
    parts.push_back({ { corners[0], cut(0, 1), cut(0, 2), cut(0, 3) } });
  }
  else
  {
    // The part is a wedge: two triangles with three edges between them.
    std::array<Corner, 6> w;
    if (inside == 3)
    {
      w = { { corners[0], corners[1], corners[2], cut(0, 3), cut(1, 3), cut(2, 3) } };
    }
    else
    {
      w = { { corners[0], cut(0, 2), cut(0, 3), corners[1], cut(1, 2), cut(1, 3) } };
    }
    parts.push_back({ { w[0], w[1], w[2], w[3] } });
    parts.push_back({ { w[1], w[2], w[3], w[4] } });
    parts.push_back({ { w[2], w[3], w[4], w[5] } });
    Sort(mesh, view, parts);
  }
  for (const Part& part : parts)
  {
    this->Order.push_back(mesh.GetNumberOfTetrahedra());
    this->AppendPart(mesh, fields, tetrahedron, part);
  }
}

void NearClip::Sort(
  const TetrahedraMesh& mesh, const TetrahedraView& view, std::vector<Part>& parts)
{
  // Each part is swapped with the next where the eye is beyond the face they share. A line of sight
  // that meets the first and the third passes the second between them.
  const glm::dvec3 eye = view.IsParallel() ? glm::dvec3(0.0, 0.0, 1e6) : glm::dvec3(0.0);
  const auto isBehind = [&](int part)
  {
    std::array<glm::dvec3, 4> p;
    for (int k = 0; k < 4; ++k)
    {
      p[k] = view.GetEyePoint(mesh.GetPoint(parts[part][k].Id));
    }
    const double ofCorner = GetSide(p[1], p[2], p[3], p[0]);
    return ofCorner * GetSide(p[1], p[2], p[3], eye) < 0.0;
  };
  const bool firstIsBehind = isBehind(0);
  const bool secondIsBehind = isBehind(1);
  if (firstIsBehind)
  {
    std::swap(parts[0], parts[1]);
  }
  if (secondIsBehind)
  {
    // The third part goes before the second, wherever that is now.
    const Part third = parts[2];
    parts.pop_back();
    parts.insert(parts.begin() + (firstIsBehind ? 0 : 1), third);
  }
}

void NearClip::AppendPart(
  TetrahedraMesh& mesh, TetrahedraFields& fields, std::uint32_t tetrahedron, const Part& part)
{
  for (const Corner& corner : part)
  {
    mesh.Corners.push_back(corner.Id);
  }
  this->Wholes.push_back(tetrahedron);
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
    // A face of the part lies in the whole's face opposite k if none of its corners needs corner k.
    unsigned int faces = 0;
    for (int face = 0; face < 4; ++face)
    {
      unsigned int support = 0;
      for (int k = 0; k < 4; ++k)
      {
        support |= k == face ? 0u : part[k].Support;
      }
      faces |= (fields.Faces[tetrahedron] & ~support & 15u) ? 1u << face : 0u;
    }
    fields.Faces.push_back(static_cast<unsigned char>(faces));
  }
}

void NearClip::AppendPoint(
  TetrahedraMesh& mesh, TetrahedraFields& fields, std::uint32_t a, std::uint32_t b, double share)
{
  for (int i = 0; i < 3; ++i)
  {
    const double from = mesh.GetPoint(a)[i];
    mesh.Points.push_back(from + share * (mesh.GetPoint(b)[i] - from));
  }
  const auto t = static_cast<float>(share);
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

void NearClip::Remove(TetrahedraMesh& mesh, TetrahedraFields& fields)
{
  if (!this->Active)
  {
    return;
  }
  this->Active = false;
  const auto shorten = [](auto& values, std::size_t size)
  {
    if (values.size() > size)
    {
      values.resize(size);
    }
  };
  mesh.Points.resize(3 * this->Points);
  mesh.Corners.resize(4 * static_cast<std::size_t>(this->Tetrahedra));
  shorten(mesh.Cells, this->Tetrahedra);
  shorten(fields.Layers, this->Tetrahedra);
  shorten(fields.Faces, this->Tetrahedra);
  shorten(fields.Normals, this->Points);
  shorten(fields.TextureCoordinates, this->Points);
  shorten(fields.Scalars, this->Points);
  shorten(fields.DeltaT, this->Points);
  shorten(
    fields.Colors, fields.Kind == TetrahedraFields::CELL_COLORS ? this->Tetrahedra : this->Points);
}

}
