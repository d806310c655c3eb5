// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkMatterGrid_h
#define vtkMatterGrid_h

#include <array>
#include <vector>

class vtkDataArray;
class vtkImageData;
class vtkMultiProcessController;
class vtkVolumeProperty;

/**
 * @class   vtkMatterGrid
 * @brief   coarse extinction of the pieces of a volume that other processes have
 *
 * The grid's cells fill the bounds of all pieces together, in coordinates along the axes of the
 * images, which have one direction matrix. Each process adds the extinction of its own samples,
 * each as wide as a voxel within the piece; the sum over all processes less the own is what is
 * outside of the own piece (LDAV 2023: a coarse global attenuation instead of an exchange of light
 * in its order).
 */
class vtkMatterGrid
{
public:
  /// The matter of one piece.
  struct Piece
  {
    /// Null where this process has none.
    vtkImageData* Image = nullptr;
    vtkDataArray* Scalars = nullptr;
    bool IsOfCells = false;
    vtkVolumeProperty* Property = nullptr;
    /// Whether light takes on the colour of what it passes: three channels instead of one.
    bool IsColored = false;
  };

  /// Returns an image's bounds along its own axes: those that its direction matrix then turns.
  static std::array<double, 6> GetBounds(vtkImageData* image);

  /**
   * Makes the grid with \a resolution cells along the longest edge. All processes of the controller
   * must call it together.
   */
  void Gather(const Piece& piece, int resolution, vtkMultiProcessController* controller);

  /// Returns whether there is matter outside of the own piece.
  bool HasMatter() const { return this->IsFilled; }
  int GetChannels() const { return this->Channels; }

  /**
   * Adds to \a depths, one for each channel, the integrals of extinction from \a from to \a to.
   */
  void Integrate(
    const std::array<double, 3>& from, const std::array<double, 3>& to, double* depths) const;

  /**
   * Returns the part of the way from \a from to \a to, 0 to 1, at which it enters the grid; 2 where
   * it does not.
   */
  double FindEntry(const std::array<double, 3>& from, const std::array<double, 3>& to) const
  {
    return FindEntry(this->Bounds, from, to);
  }
  /// Does so for any box.
  static double FindEntry(const std::array<double, 6>& bounds, const std::array<double, 3>& from,
    const std::array<double, 3>& to);

private:
  /// The share of one sample along one axis in one layer of cells.
  struct Share
  {
    int Cell;
    double Part;
  };

  std::vector<std::vector<Share>> FindShares(const Piece& piece, int axis) const;
  void Add(const Piece& piece, std::vector<float>& values) const;

  std::array<double, 6> Bounds{};
  std::array<int, 3> Size{ { 0, 0, 0 } };
  std::array<double, 3> Cell{};
  int Channels = 1;
  bool IsFilled = false;
  std::vector<float> Values;
};

#endif
