// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_NearClip_h
#define interlume_NearClip_h

#include "Mesh/TetrahedraFields.h"
#include "Mesh/TetrahedraMesh.h"
#include "View/TetrahedraView.h"

#include <array>
#include <cstdint>
#include <vector>

namespace interlume
{

/**
 * @class   NearClip
 * @brief   cuts tetrahedra at the near plane
 *
 * The rest of a tetrahedron with corners before the plane is one tetrahedron or three. They, and
 * their points, are appended to the mesh and its fields, and stand in the order where the whole one
 * stood, front to back among themselves. Views that have the mesh wholly beyond the plane cost a
 * test of its bounding box.
 */
class NearClip
{
public:
  /**
   * Appends the parts. \a order is front to back, or null for tetrahedra as they are; GetOrder() is
   * then used in its place if IsActive().
   */
  void Append(TetrahedraMesh& mesh, TetrahedraFields& fields, const TetrahedraView& view,
    const std::vector<std::uint32_t>* order);

  /**
   * Removes what was appended.
   */
  void Remove(TetrahedraMesh& mesh, TetrahedraFields& fields);

  bool IsActive() const { return this->Active; }
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

  void Cut(TetrahedraMesh& mesh, TetrahedraFields& fields, const TetrahedraView& view,
    std::uint32_t tetrahedron);
  static void Sort(
    const TetrahedraMesh& mesh, const TetrahedraView& view, std::vector<Part>& parts);
  void AppendPart(
    TetrahedraMesh& mesh, TetrahedraFields& fields, std::uint32_t tetrahedron, const Part& part);
  void AppendPoint(
    TetrahedraMesh& mesh, TetrahedraFields& fields, std::uint32_t a, std::uint32_t b, double share);

  bool Active = false;
  std::size_t Points = 0;
  std::uint32_t Tetrahedra = 0;
  std::vector<std::uint32_t> Wholes;
  std::vector<std::uint32_t> Order;
  vtkIdType NumberClipped = 0;
};

}

#endif
