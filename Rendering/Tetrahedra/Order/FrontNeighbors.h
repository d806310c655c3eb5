// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FrontNeighbors_h
#define interlume_FrontNeighbors_h

#include "Mesh/TetrahedraMesh.h"

#include <array>
#include <cstdint>
#include <vector>

namespace interlume
{

/**
 * @class   FrontNeighbors
 * @brief   finds the neighbors of each tetrahedron that must be drawn before it
 *
 * The neighbor across a face is in front if the camera is on the neighbor's side of the face's
 * plane; see EdgeOnRule for a camera in the plane. Some faces are treated as open, like boundary
 * faces: faces of tetrahedra without volume, and faces with both tetrahedra on the same side, where
 * a mesh is folded.
 */
class FrontNeighbors
{
public:
  /// Computes the data that do not depend on the view: signs of volumes, and open faces. \a twins
  /// are from FaceAdjacency.
  void Build(const TetrahedraMesh& mesh, const std::vector<std::uint32_t>& twins);

  /// Computes a bit mask for each tetrahedron: bit k is set if the neighbor across face k is in
  /// front.
  void Compute(
    const TetrahedraMesh& mesh, const Viewpoint& view, std::vector<unsigned char>& inFront) const;

  /// Returns the indices (see FaceAdjacency) of the open faces of tetrahedra with nonzero volume,
  /// ascending.
  const std::vector<std::uint32_t>& GetOpenFaces() const { return this->OpenFaces; }
  /// Returns the corners of a face, counterclockwise as seen from outside of its tetrahedron.
  std::array<std::uint32_t, 3> GetOutwardCorners(
    const TetrahedraMesh& mesh, std::uint32_t face) const;
  /// Returns the largest distance of a point from the mesh's origin.
  double GetRadius() const { return this->Radius; }

  /// Returns the memory size in bytes: one byte per tetrahedron, plus the list of open faces.
  std::size_t GetBytes() const;

private:
  // Bits of each tetrahedron: bit k is set if face k is not open, and IsPositive is set if the
  // volume is positive.
  static constexpr unsigned int Passable = 0xf;
  static constexpr unsigned int IsPositive = 0x10;
  std::vector<unsigned char> Tetrahedra;
  std::vector<std::uint32_t> OpenFaces;
  double Radius = 0.0;
};

}

#endif
