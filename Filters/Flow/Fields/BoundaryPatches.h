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
 * @brief   the outer faces of a grid in patches, as the sides, inlets and walls of a domain
 *
 * Faces that share an edge, with no third one there, are of one patch where they bend there by no
 * more than FeatureAngle. Patches are numbered by their first face.
 */
class BoundaryPatches
{
public:
  /// The angle between faces beyond which an edge parts patches, in degrees.
  static constexpr double FeatureAngle = 30.0;

  /// A function that gives the points of a face in cyclic order, and returns how many, three or
  /// four.
  using FacePoints = std::function<int(vtkIdType face, vtkIdType* points)>;

  /// Takes faces by ascending numbers.
  void Build(
    const std::vector<vtkIdType>& faces, const FacePoints& getPoints, const ArrayRows& positions);

  int GetNumberOfPatches() const { return static_cast<int>(this->Patches.size()); }
  /// Returns the patch of a face; -1 for a face that is none of those.
  int Find(vtkIdType face) const;
  /// Computes the two coordinates other than that which the patch looks along most, in parts of its
  /// bounds.
  void GetParameters(int patch, const double x[3], double uv[2]) const;

private:
  struct Patch
  {
    glm::dvec3 Lower;
    glm::dvec3 Upper;
    /// The sum of the absolute components of all faces' areas.
    glm::dvec3 Area;
  };

  /// Numbers the patches in the order of each one's first face.
  void Number(const std::vector<int>& firsts);
  /// Adds the face at this index to its patch.
  void Add(std::size_t index, const double (*corners)[3], int number);

  std::vector<vtkIdType> Faces;
  std::vector<int> PatchIds;
  std::vector<Patch> Patches;
};

}

#endif
