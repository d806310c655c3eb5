// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_EyeSides_h
#define interlume_EyeSides_h

#include "Mesh/TetrahedraMesh.h"

#include <array>
#include <cstdint>
#include <vector>

namespace interlume
{

/**
 * @class   EyeSides
 * @brief   the faces beyond which a tetrahedron has a neighbour that must be drawn before it
 *
 * The neighbour beyond a face is in front where the eye is on its side of the face's plane; see
 * EdgeOnRule for an eye in the plane. A face whose two tetrahedra lie on one side of it, as
 * where a mesh is folded, and the faces of a tetrahedron without volume lead nowhere: they are
 * open, like those of the boundary.
 */
class EyeSides
{
public:
  /// Computes what does not depend on the view: volumes' signs and open faces. \a twins are those
  /// of FaceAdjacency.
  void Build(const TetrahedraMesh& mesh, const std::vector<std::uint32_t>& twins);

  /// Computes for each tetrahedron one bit for each face beyond which its neighbour is in front: 1
  /// << k.
  void Compute(
    const TetrahedraMesh& mesh, const Viewpoint& view, std::vector<unsigned char>& inFront) const;

  /// Returns the open faces of tetrahedra that have a volume, ascending, numbered as by
  /// FaceAdjacency.
  const std::vector<std::uint32_t>& GetOpenFaces() const { return this->OpenFaces; }
  /// Returns the corners of a face, counterclockwise as seen from outside of its tetrahedron.
  std::array<std::uint32_t, 3> GetOutwardCorners(
    const TetrahedraMesh& mesh, std::uint32_t face) const;
  /// Returns the greatest distance of a point from the mesh's origin.
  double GetRadius() const { return this->Radius; }

  /// Returns the bytes held: one a tetrahedron, and the open faces.
  std::size_t GetBytes() const;

private:
  // The bits of each tetrahedron: bit k tells whether face k leads to a neighbour, another whether
  // its corners are in the order of a positive volume.
  static constexpr unsigned int Passable = 0xf;
  static constexpr unsigned int IsPositive = 0x10;
  std::vector<unsigned char> Tetrahedra;
  std::vector<std::uint32_t> OpenFaces;
  double Radius = 0.0;
};

}

#endif
