// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_PiecewiseLinearTransferFunction_h
#define interlume_PiecewiseLinearTransferFunction_h

#include <array>
#include <cstddef>
#include <vector>

class vtkVolumeProperty;

namespace interlume
{

/**
 * @class   PiecewiseLinearTransferFunction
 * @brief   color and extinction as a piecewise linear function of the scalar
 *
 * It merges the control points of the color and opacity functions of a property, so that all four
 * channels are linear between adjacent control points. Curved pieces (other color spaces,
 * midpoints, sharpness, logarithmic scale) are bisected until the linear pieces are within a
 * tolerance of the functions. Collinear control points are removed.
 */
class PiecewiseLinearTransferFunction
{
public:
  using Sample = std::array<float, 4>;

  /**
   * Samples the functions of \a component over \a range, which is mapped to [0, 1]. Extinction is
   * opacity times \a unit. \a tolerance is the largest error of a color channel, and the largest
   * relative error of the extinction.
   */
  void Build(vtkVolumeProperty* property, int component, const double range[2], double unit,
    double tolerance = 1e-4);

  int GetNumberOfPieces() const { return static_cast<int>(this->Pieces.size()); }

  /// A linear piece: Value + Slope (f - start) for a normalized scalar f from the start of the
  /// piece to the start of the next.
  struct alignas(16) Piece
  {
    Sample Value;
    Sample Slope;
  };
  const std::vector<Piece>& GetPieces() const { return this->Pieces; }
  /// Returns the start of each piece, followed by a number that is larger than any scalar.
  const std::vector<float>& GetStarts() const { return this->Starts; }

  /// Return the extinction components of each piece's Value and Slope, for loops that do not need
  /// color.
  const std::vector<float>& GetExtinctions() const { return this->Extinctions; }
  const std::vector<float>& GetExtinctionSlopes() const { return this->ExtinctionSlopes; }
  /// Returns the indices of the pieces that contain i / 1024, for i from 0 to 1024.
  const std::vector<int>& GetBuckets() const { return this->First; }

  /// Returns the index of the piece that contains \a f, which must be in [0, 1].
  int Find(float f) const
  {
    int piece = this->First[static_cast<std::size_t>(f * BUCKETS)];
    while (f >= this->Starts[piece + 1])
    {
      ++piece;
    }
    return piece;
  }

  Sample Evaluate(int piece, float f) const
  {
    Sample sample;
    this->Evaluate(piece, f, sample);
    return sample;
  }
  void Evaluate(int piece, float f, Sample& sample) const
  {
    const Piece& p = this->Pieces[piece];
    const float offset = f - this->Starts[piece];
    for (int i = 0; i < 4; ++i)
    {
      sample[i] = p.Value[i] + p.Slope[i] * offset;
    }
  }

  /// Returns true if the color, but not necessarily the extinction, is the same for all scalars.
  bool HasConstantColor() const;

private:
  static constexpr int BUCKETS = 1024;

  struct Node
  {
    double X;
    std::array<double, 4> Value;
  };
  void SetNodes(const std::vector<Node>& nodes);

  std::vector<Piece> Pieces;
  std::vector<float> Starts;
  std::vector<float> Extinctions;
  std::vector<float> ExtinctionSlopes;
  /// Index of the piece that contains i / BUCKETS, for i from 0 to BUCKETS.
  std::vector<int> First;
};

}

#endif
