#ifndef interlume_BoundaryPatches_h
#define interlume_BoundaryPatches_h

#include "Fields/ArrayRows.h"

#include "vtkType.h"

#include <array>
#include <functional>
#include <vector>

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
  /// In degrees.
  static constexpr double FeatureAngle = 30.0;

  /// The points of a face in cyclic order; returns how many, three or four.
  using FacePoints = std::function<int(vtkIdType face, vtkIdType* points)>;

  /// Takes faces by ascending numbers.
  void Build(
    const std::vector<vtkIdType>& faces, const FacePoints& getPoints, const ArrayRows& positions);

  int GetNumberOfPatches() const { return static_cast<int>(this->Patches.size()); }
  /// The patch of a face; -1 for a face that is none of those.
  int Find(vtkIdType face) const;
  /// The two coordinates other than that which the patch looks along most, in parts of its bounds.
  void GetParameters(int patch, const double x[3], double uv[2]) const;

private:
  struct Patch
  {
    std::array<double, 3> Lower;
    std::array<double, 3> Upper;
    /// The sum of the absolute components of all faces' areas.
    std::array<double, 3> Area;
  };

  /// Numbers in the place of each face's first one.
  void Number(const std::vector<int>& firsts);
  /// To the patch of the face at this index.
  void Add(std::size_t index, const double (*corners)[3], int number);

  std::vector<vtkIdType> Faces;
  std::vector<int> PatchIds;
  std::vector<Patch> Patches;
};

}

#endif
