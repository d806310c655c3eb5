// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ExtinctionGrid_h
#define interlume_ExtinctionGrid_h

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
 * @class   ExtinctionGrid
 * @brief   mean extinction and albedo of volumes in the cells of a box
 *
 * The box encloses the visible blocks of all volumes that scatter, clipped to their cropping
 * regions. It is aligned with the edges of the first of these volumes if those edges are orthogonal
 * and the other volumes' edges are parallel to them. Otherwise it is aligned with the world axes.
 * All volumes share one unit space. Box coordinates are unit space coordinates, rotated to the axes
 * of the box and relative to its lower corner. Extinctions are per unit length in box coordinates.
 *
 * Cells are as close to cubes as integer cell counts allow. A box thinner than half a cell is
 * enlarged to half a cell. With multiple volumes, cells are as small as the smallest cells that any
 * of the volumes would have alone, but the number of cells along the longest edge is limited to the
 * larger of MaximumSharedCells and the largest number that a single volume requests.
 *
 * Extinctions of overlapping volumes are added. The medium of a volume that does not scatter only
 * absorbs.
 *
 * The extinction of a cell is the mean of 2 to 8 samples along each axis, one per voxel if
 * possible. Samples are interpolated and then classified, as in the slice shaders, so that a cell
 * has the same optical depth as the medium inside it. The albedo is the mean weighted by
 * extinction. If the medium has a transmission color, only the part of each color that is not
 * transmitted is scattered.
 */
class ExtinctionGrid
{
public:
  /// A volume to sample.
  struct Volume
  {
    const VolumeSamples& Samples;
    const VolumeBlocks& Blocks;
    const MaterialTable& Material;
    const UnitSpace& Space;
    const ClipRegion& Region;
    /// See VolumeRenderState.
    glm::dvec3 GradientSteps;
    /// Scalar opacity unit distances, one per row of the material table.
    std::array<double, 4> UnitDistances;
    /// Requested number of cells along the volume's longest edge. A volume with fewer voxels gets
    /// fewer cells.
    int Cells;
    bool Scatters;
  };

  /// Default limit for the number of cells along the longest edge of a grid of multiple volumes.
  static constexpr int MaximumSharedCells = 64;

  /**
   * Computes the medium except for its phase function. Returns false if no visible part of the
   * volumes scatters light. The result does not depend on the number of threads.
   */
  bool Build(const std::vector<Volume>& volumes);

  const ScatteringMedium& GetMedium() const { return this->Medium; }
  ScatteringMedium& GetMedium() { return this->Medium; }
  /// Returns the fraction of each cell's extinction that applies to red, green and blue. The result
  /// is empty if all fractions are 1.
  const std::vector<glm::vec3>& GetColorFractions() const { return this->ColorFractions; }

  ///@{
  /// Transform between unit space and box coordinates.
  glm::dvec3 FromUnit(const glm::dvec3& position) const
  {
    return (position - this->Origin) * this->Axes;
  }
  glm::dvec3 DirectionFromUnit(const glm::dvec3& direction) const { return direction * this->Axes; }
  glm::dvec3 ToUnit(const glm::dvec3& position) const
  {
    return this->Axes * position + this->Origin;
  }
  glm::dvec3 DirectionToUnit(const glm::dvec3& direction) const { return this->Axes * direction; }
  ///@}
  /// Returns the center of a cell in box coordinates.
  glm::dvec3 GetCellCenter(const glm::ivec3& cell) const
  {
    return (glm::dvec3(cell) + 0.5) * this->Medium.CellSize;
  }
  glm::ivec3 GetCell(std::size_t index) const;

private:
  bool SetBox(const std::vector<Volume>& volumes);

  ScatteringMedium Medium;
  std::vector<glm::vec3> ColorFractions;
  /// Lower corner and unit axes of the box in unit space.
  glm::dvec3 Origin{ 0.0 };
  glm::dmat3 Axes{ 1.0 };
  /// Number of samples in a cell along each axis.
  glm::ivec3 Steps{ 1 };
};

}

#endif
