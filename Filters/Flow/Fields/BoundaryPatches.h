// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_BoundaryPatches_h
#define interlume_BoundaryPatches_h

#include "Common/ArrayRows.h"

#include "vtkType.h"

#include <functional>
#include <vector>

#include <glm/vec3.hpp>

namespace interlume
{

/**
 * @class   BoundaryPatches
 * @brief   groups the boundary faces of a grid into patches, such as sides, inlets and walls
 *
 * Two faces that share an edge belong to the same patch if no third face shares the edge and the
 * angle between the normals of the faces is at most FeatureAngle. Patches are numbered in the order
 * of their first faces.
 */
class BoundaryPatches
{
public:
  /// Largest angle between the normals of adjacent faces of a patch, in degrees.
  static constexpr double FeatureAngle = 30.0;

  /// Callback that writes the point ids of a face in cyclic order to \a points and returns their
  /// number, three or four.
  using FacePoints = std::function<int(vtkIdType face, vtkIdType* points)>;

  /// Builds the patches from the ids of all boundary faces, in ascending order.
  void Build(
    const std::vector<vtkIdType>& faces, const FacePoints& getPoints, const ArrayRows& positions);

  int GetNumberOfPatches() const { return static_cast<int>(this->Patches.size()); }
  /// Returns the patch of a face, or -1 if the face is not a boundary face.
  int Find(vtkIdType face) const;
  /// Computes the parameters (u,v) of a point on a patch: the coordinates along the two axes most
  /// nearly parallel to the patch, mapped from the bounds of the patch to [0,1].
  void GetParameters(int patch, const double x[3], double uv[2]) const;

private:
  struct Patch
  {
    glm::dvec3 Lower;
    glm::dvec3 Upper;
    /// Sum of the absolute values of the faces' area vectors, component by component.
    glm::dvec3 Area;
  };

  /// Numbers the patches in the order of their first faces. \a firsts contains, for each face, the
  /// index of the first face of its patch.
  void Number(const std::vector<int>& firsts);
  /// Adds the face with the given index to its patch.
  void Add(std::size_t index, const double (*corners)[3], int number);

  std::vector<vtkIdType> Faces;
  std::vector<int> PatchIds;
  std::vector<Patch> Patches;
};

}

#endif
