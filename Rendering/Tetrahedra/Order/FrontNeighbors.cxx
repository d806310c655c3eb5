// SPDX-License-Identifier: BSD-3-Clause
#include "Order/FrontNeighbors.h"

#include "Common/ParallelFor.h"
#include "Common/Vectors.h"
#include "Order/EdgeOnRule.h"
#include "Order/FaceAdjacency.h"

#include <utility>

namespace interlume
{

namespace
{
constexpr vtkIdType NeighborGrain = 8192;

// Corners of each face, counterclockwise as seen from outside if the volume is positive.
constexpr int Outward[4][3] = { { 1, 2, 3 }, { 0, 3, 2 }, { 0, 1, 3 }, { 0, 2, 1 } };

// The first corner of a tetrahedron and the edges from it to the other corners.
struct Edges
{
  Edges(const TetrahedraMesh& mesh, std::uint32_t tetrahedron)
  {
    const std::uint32_t* corners = mesh.GetCorners(tetrahedron);
    this->Origin = glm::make_vec3(mesh.GetPoint(corners[0]));
    this->U = glm::make_vec3(mesh.GetPoint(corners[1])) - this->Origin;
    this->V = glm::make_vec3(mesh.GetPoint(corners[2])) - this->Origin;
    this->W = glm::make_vec3(mesh.GetPoint(corners[3])) - this->Origin;
  }

  glm::dvec3 Origin;
  glm::dvec3 U;
  glm::dvec3 V;
  glm::dvec3 W;
};

// Bits that describe the orientation of a tetrahedron. Bit k (0 to 3) is set if the point ids of
// face k, counterclockwise as seen from outside, are an odd permutation of the sorted ids. If two
// tetrahedra are on opposite sides of a shared face, their bits for this face differ.
constexpr unsigned int PositiveBit = 0x10;
constexpr unsigned int FlatBit = 0x20;

unsigned char FindOrientation(const TetrahedraMesh& mesh, std::uint32_t tetrahedron)
{
  const Edges edges(mesh, tetrahedron);
  const double volume = glm::dot(edges.U, glm::cross(edges.V, edges.W));
  const std::uint32_t* corners = mesh.GetCorners(tetrahedron);
  unsigned int result = volume > 0.0 ? PositiveBit : volume < 0.0 ? 0u : FlatBit;
  for (int k = 0; k < 4; ++k)
  {
    const std::uint32_t a = corners[Outward[k][0]];
    const std::uint32_t b = corners[Outward[k][1]];
    const std::uint32_t c = corners[Outward[k][2]];
    const bool isOdd = ((a > b) != (b > c)) != (a > c);
    result |= static_cast<unsigned int>(isOdd != (volume < 0.0)) << k;
  }
  return static_cast<unsigned char>(result);
}
}

void FrontNeighbors::Build(const TetrahedraMesh& mesh, const std::vector<std::uint32_t>& twins)
{
  this->Radius = mesh.GetRadius();
  const std::uint32_t number = mesh.GetNumberOfTetrahedra();
  std::vector<unsigned char> orientations(number);
  ParallelFor(0, number, NeighborGrain,
    [&](vtkIdType t) { orientations[t] = FindOrientation(mesh, static_cast<std::uint32_t>(t)); });
  this->Tetrahedra.resize(number);
  this->OpenFaces.clear();
  for (std::uint32_t t = 0; t < number; ++t)
  {
    const unsigned int own = orientations[t];
    unsigned int flags = own & PositiveBit ? IsPositive : 0u;
    for (std::uint32_t face = 4 * t; face < 4 * t + 4 && !(own & FlatBit); ++face)
    {
      const std::uint32_t twin = twins[face];
      const unsigned int other = twin == FaceAdjacency::None ? FlatBit : orientations[twin / 4];
      if (!(other & FlatBit) && ((own >> (face & 3) ^ other >> (twin & 3)) & 1))
      {
        flags |= 1u << (face & 3);
      }
      else
      {
        this->OpenFaces.push_back(face);
      }
    }
    this->Tetrahedra[t] = static_cast<unsigned char>(flags);
  }
}

void FrontNeighbors::Compute(
  const TetrahedraMesh& mesh, const Viewpoint& view, std::vector<unsigned char>& inFront) const
{
  const EdgeOnRule rule(view, this->Radius);
  inFront.resize(this->Tetrahedra.size());
  ParallelFor(0, static_cast<vtkIdType>(this->Tetrahedra.size()), NeighborGrain,
    [&](vtkIdType t)
    {
      const Edges e(mesh, static_cast<std::uint32_t>(t));
      const glm::dvec3 towardEye = rule.GetVectorToEye(e.Origin);
      const glm::dvec3 towardEye1 =
        rule.GetVectorToEye(glm::make_vec3(mesh.GetPoint(mesh.GetCorners(t)[1])));
      const glm::dvec3 edge12 = e.V - e.U;
      const glm::dvec3 edge13 = e.W - e.U;
      const double u = Vectors::InfinityNorm(e.U);
      const double v = Vectors::InfinityNorm(e.V);
      const double w = Vectors::InfinityNorm(e.W);
      // sides[k] is positive if the camera and corner k are on the same side of face k.
      const double sign = this->Tetrahedra[t] & IsPositive ? 1.0 : -1.0;
      const double sides[4] = { -sign * glm::dot(glm::cross(edge12, edge13), towardEye1),
        sign * glm::dot(glm::cross(e.V, e.W), towardEye),
        sign * glm::dot(glm::cross(e.W, e.U), towardEye),
        sign * glm::dot(glm::cross(e.U, e.V), towardEye) };
      const double sizes[4] = { Vectors::InfinityNorm(edge12) + Vectors::InfinityNorm(edge13),
        v + w, w + u, u + v };
      unsigned int outside = 0;
      for (int k = 0; k < 4; ++k)
      {
        outside |= static_cast<unsigned int>(sides[k] < -rule.GetBound(sizes[k])) << k;
      }
      inFront[t] = static_cast<unsigned char>(outside & this->Tetrahedra[t] & Passable);
    });
}

std::array<std::uint32_t, 3> FrontNeighbors::GetOutwardCorners(
  const TetrahedraMesh& mesh, std::uint32_t face) const
{
  const std::uint32_t* corners = mesh.GetCorners(face / 4);
  const int* outward = Outward[face & 3];
  std::array<std::uint32_t, 3> ids = { { corners[outward[0]], corners[outward[1]],
    corners[outward[2]] } };
  if (!(this->Tetrahedra[face / 4] & IsPositive))
  {
    std::swap(ids[1], ids[2]);
  }
  return ids;
}

std::size_t FrontNeighbors::GetBytes() const
{
  return this->Tetrahedra.capacity() + this->OpenFaces.capacity() * sizeof(std::uint32_t);
}

}
