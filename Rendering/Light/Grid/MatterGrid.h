// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_MatterGrid_h
#define interlume_MatterGrid_h

#include "Scattering/ScatteringMedium.h"

#include <array>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace interlume
{

class ClipRegion;
class MaterialTable;
class UnitSpace;
class VolumeBlocks;
class VolumeSamples;

/**
 * @class   MatterGrid
 * @brief   the matter of volumes in the cells of a box, as its mean in each
 *
 * The box is around the blocks that can be seen of all volumes that scatter, within what cropping
 * leaves, along the edges of the first one where these are perpendicular and the others' are
 * parallel to them, else along the axes of the world. Its coordinates are those of unit space,
 * which all volumes share, from its lower corner, turned to its axes; extinctions are for lengths
 * there. Cells are as cubic as whole numbers of them allow; a box thinner than half a cell becomes
 * as thick as that. Those of several volumes are as small as the smallest that one of them has by
 * itself, but no more than MostTogether along the longest edge, or what one of them asks for.
 *
 * Extinctions of volumes add up. Matter of a volume that does not scatter takes light.
 *
 * A cell has the mean extinction of up to 8 samples along each axis, one for each voxel as far as
 * that goes and 2 at least, interpolated and then classified as the slices do, so that the optical
 * depth of a cell is that of its matter; and the mean albedo of its matter, by extinction. Where
 * matter lets light through by a colour of its own only the rest of each colour is scattered.
 */
class MatterGrid
{
public:
  /// What the grid is made of.
  struct Volume
  {
    const VolumeSamples& Samples;
    const VolumeBlocks& Blocks;
    const MaterialTable& Material;
    const UnitSpace& Space;
    const ClipRegion& Region;
    /// See VolumeRenderState.
    glm::dvec3 GradientSteps;
    /// Of each row.
    std::array<double, 4> UnitDistances;
    /// The cells along the volume's longest edge; it has fewer where it has fewer voxels.
    int Cells;
    bool Scatters;
  };

  /// The largest automatic number of cells along the longest edge of several volumes.
  static constexpr int MostTogether = 64;

  /**
   * Fills the medium but for its phase function. Returns false where nothing can be seen that
   * scatters. The result is the same for any number of threads.
   */
  bool Build(const std::vector<Volume>& volumes);

  const ScatteringMedium& GetMedium() const { return this->Medium; }
  ScatteringMedium& GetMedium() { return this->Medium; }
  /// The share of each cell's extinction that takes from red, green and blue; empty where it is
  /// all.
  const std::vector<glm::vec3>& GetParts() const { return this->Parts; }

  ///@{
  /// Between unit space and the box.
  glm::dvec3 FromUnit(const glm::dvec3& place) const { return (place - this->Origin) * this->Axes; }
  glm::dvec3 DirectionFromUnit(const glm::dvec3& direction) const { return direction * this->Axes; }
  glm::dvec3 ToUnit(const glm::dvec3& place) const { return this->Axes * place + this->Origin; }
  glm::dvec3 DirectionToUnit(const glm::dvec3& direction) const { return this->Axes * direction; }
  ///@}
  /// The middle of a cell, in the box.
  glm::dvec3 GetMiddle(const glm::ivec3& cell) const
  {
    return (glm::dvec3(cell) + 0.5) * this->Medium.CellSize;
  }
  glm::ivec3 GetCell(std::size_t index) const;

private:
  bool PlaceBox(const std::vector<Volume>& volumes);

  ScatteringMedium Medium;
  std::vector<glm::vec3> Parts;
  /// The box's lower corner and axes, of length 1, in unit space.
  glm::dvec3 Origin{ 0.0 };
  glm::dmat3 Axes{ 1.0 };
  /// The samples along each axis of a cell.
  glm::ivec3 Steps{ 1 };
};

}

#endif
