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
 * If a plane cuts a tetrahedron, one to three parts remain. The parts are tetrahedra, which the
 * next plane cuts in turn. The final parts and their points are appended to the mesh and its
 * fields. In the drawing order, the parts replace the original tetrahedron, sorted front to back.
 * The appended data do not depend on the view: if the camera moves but the planes do not, only the
 * order is uploaded again. A plane outside the mesh's bounding box costs only the box test.
 */
class PlaneClip
{
public:
  /// A plane with a unit normal. It cuts off points p with dot(plane, (p, 1)) < 0.
  using Plane = glm::dvec4;

  /**
   * Appends the parts. \a order lists tetrahedra from front to back; null means mesh order without
   * sorting. If IsActive() then returns true, use GetOrder() instead of \a order.
   */
  void Append(TetrahedraMesh& mesh, TetrahedraFields& fields, const std::vector<Plane>& planes,
    const Viewpoint& view, const std::vector<std::uint32_t>* order);

  /**
   * Removes the appended parts, points and values.
   */
  void Remove(TetrahedraMesh& mesh, TetrahedraFields& fields);

  bool IsActive() const { return !this->Planes.empty(); }
  /// Returns the planes that cut the mesh.
  const std::vector<Plane>& GetPlanes() const { return this->Planes; }
  const std::vector<std::uint32_t>& GetOrder() const { return this->Order; }
  vtkIdType GetNumberOfClippedTetrahedra() const { return this->NumberClipped; }
  /// Returns the original tetrahedron of a part; for other tetrahedra, the tetrahedron itself.
  std::uint32_t GetOriginal(std::uint32_t tetrahedron) const
  {
    return tetrahedron < this->Tetrahedra ? tetrahedron
                                          : this->Originals[tetrahedron - this->Tetrahedra];
  }

private:
  /// A corner of a part. Bit k of Support is set if the corner depends on corner k of the original
  /// tetrahedron.
  struct Corner
  {
    std::uint32_t Id;
    unsigned int Support;
  };
  using Part = std::array<Corner, 4>;
  /// A range of indices into the member Parts.
  struct Range
  {
    std::size_t Begin;
    std::size_t End;
  };

  /// Classifies tetrahedra as retained, dropped or cut.
  void Classify(const TetrahedraMesh& mesh);
  void CutTetrahedra(TetrahedraMesh& mesh, TetrahedraFields& fields, const Viewpoint* view);
  /// Cuts a part of a tetrahedron with the planes from index \a plane on. Appends the remaining
  /// parts to the mesh and to Parts, front to back unless \a view is null.
  void Cut(TetrahedraMesh& mesh, TetrahedraFields& fields, const Viewpoint* view,
    std::uint32_t tetrahedron, const Part& part, std::size_t plane);
  /// Cuts a part with a plane, given the signed distances of its corners from the plane, and
  /// appends new points. Returns up to three parts. The first three corners of each part are the
  /// last three of the previous part.
  static std::vector<Part> Split(TetrahedraMesh& mesh, TetrahedraFields& fields, const Part& part,
    const std::array<double, 4>& distances);
  /// Sorts the entries at the end of Parts front to back. \a ranges contains the range of entries
  /// of each of the \a parts from Split().
  void Sort(const TetrahedraMesh& mesh, const Viewpoint& view, const std::vector<Part>& parts,
    const std::vector<Range>& ranges);
  void AppendPart(
    TetrahedraMesh& mesh, TetrahedraFields& fields, std::uint32_t tetrahedron, const Part& part);
  static void AppendPoint(TetrahedraMesh& mesh, TetrahedraFields& fields, std::uint32_t a,
    std::uint32_t b, double fraction);
  void BuildOrder(const std::vector<std::uint32_t>* order);

  std::vector<Plane> Planes;
  std::size_t Points = 0;
  std::uint32_t Tetrahedra = 0;
  /// For each tetrahedron, RETAINED, DROPPED, or the index in Ranges of its parts.
  std::vector<std::uint32_t> States;
  std::vector<Range> Ranges;
  std::vector<std::uint32_t> Parts;
  std::vector<std::uint32_t> Originals;
  std::vector<std::uint32_t> Order;
  vtkIdType NumberClipped = 0;
};

}

#endif
