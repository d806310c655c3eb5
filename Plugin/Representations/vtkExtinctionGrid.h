// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkExtinctionGrid_h
#define vtkExtinctionGrid_h

#include <array>
#include <vector>

class vtkDataArray;
class vtkImageData;
class vtkMultiProcessController;
class vtkVolumeProperty;

/**
 * @class   vtkExtinctionGrid
 * @brief   stores the extinction of the other processes' pieces of a volume on a coarse grid
 *
 * The grid covers the bounds of all pieces. Its axes are those of the images, which share one
 * direction matrix. Each process adds the extinction of its samples; a sample fills one voxel,
 * clipped to the piece. The sum over all processes minus the local contribution is the extinction
 * outside the local piece. With this coarse attenuation, processes need not wait for the light that
 * has passed through the pieces of other processes.
 */
class vtkExtinctionGrid
{
public:
  /// The local piece of the volume.
  struct Piece
  {
    /// Null if this process has no piece.
    vtkImageData* Image = nullptr;
    vtkDataArray* Scalars = nullptr;
    bool IsOfCells = false;
    vtkVolumeProperty* Property = nullptr;
    /// Whether extinction differs between color channels, so that three channels are stored, not
    /// one.
    bool IsColored = false;
  };

  /// Returns the bounds of an image along its axes, before its direction matrix is applied.
  static std::array<double, 6> GetBounds(vtkImageData* image);

  /**
   * Computes the grid, with \a resolution cells along the longest edge. All processes of the
   * controller must call it together.
   */
  void Gather(const Piece& piece, int resolution, vtkMultiProcessController* controller);

  /// Returns true if the extinction outside the local piece is above 0 anywhere.
  bool HasMedium() const { return this->IsFilled; }
  int GetChannels() const { return this->Channels; }

  /**
   * Increases \a depths, one value per channel, by the optical depth between \a from and \a to.
   */
  void Integrate(
    const std::array<double, 3>& from, const std::array<double, 3>& to, double* depths) const;

  /**
   * Returns the position along the line from \a from (0) to \a to (1) at which the line enters the
   * grid, or 2 if it misses the grid.
   */
  double FindEntry(const std::array<double, 3>& from, const std::array<double, 3>& to) const
  {
    return FindEntry(this->Bounds, from, to);
  }
  /// Returns the position along the line, 0 to 1, at which it enters the box \a bounds, or 2 if it
  /// misses the box.
  static double FindEntry(const std::array<double, 6>& bounds, const std::array<double, 3>& from,
    const std::array<double, 3>& to);

private:
  /// Overlap of a sample with a layer of cells along one axis, as a fraction of the cell size.
  struct Overlap
  {
    int Cell;
    double Fraction;
  };

  /// Returns the overlaps of each sample along one axis.
  std::vector<std::vector<Overlap>> FindOverlaps(const Piece& piece, int axis) const;
  /// Adds the extinction of the samples of a piece to \a values.
  void Add(const Piece& piece, std::vector<float>& values) const;

  std::array<double, 6> Bounds{};
  std::array<int, 3> Size{ { 0, 0, 0 } };
  std::array<double, 3> Cell{};
  int Channels = 1;
  bool IsFilled = false;
  std::vector<float> Values;
};

#endif
