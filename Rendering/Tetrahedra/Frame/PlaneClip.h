// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_PlaneClip_h
#define interlume_PlaneClip_h

#include "Mesh/TetrahedraFields.h"
#include "Mesh/TetrahedraMesh.h"

#include "vtkType.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec4.hpp>

namespace interlume
{

/**
 * @class   PlaneClip
 * @brief   cuts tetrahedra at the near plane and at clipping planes
 *
 * The rest of a tetrahedron beyond a plane is one tetrahedron or three, which the next plane cuts
 * in turn. These parts and their points are appended to the mesh and its fields. They replace the
 * tetrahedron in the order, sorted front to back. The appended data do not depend on the view, so
 * if the view moves and the planes do not, only the order is uploaded. Planes outside the mesh's
 * bounding box cost only the test of the box.
 */
class PlaneClip
{
public:
  /// A plane with a normal of unit length. Points p with dot(plane, (p, 1)) < 0 are cut off.
  using Plane = glm::dvec4;

  /**
   * Appends the parts. \a order is front to back, or null for tetrahedra as they are; GetOrder() is
   * then used in its place if IsActive().
   */
  void Append(TetrahedraMesh& mesh, TetrahedraFields& fields, const std::vector<Plane>& planes,
    const Viewpoint& view, const std::vector<std::uint32_t>* order);

  /**
   * Removes what was appended.
   */
  void Remove(TetrahedraMesh& mesh, TetrahedraFields& fields);

  bool IsActive() const { return !this->Planes.empty(); }
  /// Returns the planes that cut off points of the mesh.
  const std::vector<Plane>& GetPlanes() const { return this->Planes; }
  const std::vector<std::uint32_t>& GetOrder() const { return this->Order; }
  vtkIdType GetNumberClipped() const { return this->NumberClipped; }
  /// Returns the tetrahedron that one was cut from, or itself.
  std::uint32_t GetWhole(std::uint32_t tetrahedron) const
  {
    return tetrahedron < this->Tetrahedra ? tetrahedron
                                          : this->Wholes[tetrahedron - this->Tetrahedra];
  }

private:
  /// A corner of a part, and the whole's corners that it lies between, one bit for each.
  struct Corner
  {
    std::uint32_t Id;
    unsigned int Support;
  };
  using Part = std::array<Corner, 4>;
  /// A range of Parts.
  struct Range
  {
    std::size_t Begin;
    std::size_t End;
  };

  /// Finds the tetrahedra that are kept, dropped, or cut.
  void Classify(const TetrahedraMesh& mesh);
  void CutAll(TetrahedraMesh& mesh, TetrahedraFields& fields, const Viewpoint* view);
  /// Cuts a part of a tetrahedron by all planes from one on, and appends what is left of it to the
  /// mesh and to Parts, front to back unless \a view is null.
  void Cut(TetrahedraMesh& mesh, TetrahedraFields& fields, const Viewpoint* view,
    std::uint32_t tetrahedron, const Part& part, std::size_t plane);
  /// Cuts a part by a plane at these distances from its corners, and appends the points of the cut.
  /// Returns up to three parts; each starts with the last three corners of the previous one.
  static std::vector<Part> Split(TetrahedraMesh& mesh, TetrahedraFields& fields, const Part& part,
    const std::array<double, 4>& distances);
  /// Sorts the last ranges of Parts, one for each part from Split(), front to back.
  void Sort(const TetrahedraMesh& mesh, const Viewpoint& view, const std::vector<Part>& parts,
    const std::vector<Range>& ranges);
  void AppendPart(
    TetrahedraMesh& mesh, TetrahedraFields& fields, std::uint32_t tetrahedron, const Part& part);
  static void AppendPoint(
    TetrahedraMesh& mesh, TetrahedraFields& fields, std::uint32_t a, std::uint32_t b, double share);
  void MakeOrder(const std::vector<std::uint32_t>* order);

  std::vector<Plane> Planes;
  std::size_t Points = 0;
  std::uint32_t Tetrahedra = 0;
  /// KEPT or DROPPED for each tetrahedron, or the index of its range.
  std::vector<std::uint32_t> Fates;
  std::vector<Range> Ranges;
  std::vector<std::uint32_t> Parts;
  std::vector<std::uint32_t> Wholes;
  std::vector<std::uint32_t> Order;
  vtkIdType NumberClipped = 0;
};

}

#endif
