// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_PiecewiseLinearTransfer_h
#define interlume_PiecewiseLinearTransfer_h

#include <array>
#include <cstddef>
#include <vector>

class vtkVolumeProperty;

namespace interlume
{

/**
 * @class   PiecewiseLinearTransfer
 * @brief   colour and extinction as straight pieces over the scalar
 *
 * It puts the colour and opacity functions of a property together: between two control points all
 * four channels are linear in the scalar. Curved parts of the functions (other colour spaces,
 * midpoints, sharpness, logarithmic scale) are halved until straight pieces are within 1e-4 of
 * them, and control points on a straight line are dropped.
 */
class PiecewiseLinearTransfer
{
public:
  using Sample = std::array<float, 4>;

  /**
   * Takes the functions of \a component over [\a range[0], \a range[1]], which become 0 to 1.
   * Extinction is the opacity times \a unit.
   */
  void Build(vtkVolumeProperty* property, int component, const double range[2], double unit);

  int GetNumberOfPieces() const { return static_cast<int>(this->Pieces.size()); }

  /// One piece: Value + Slope (f - start), from its start to that of the next.
  struct alignas(16) Piece
  {
    Sample Value;
    Sample Slope;
  };
  const std::vector<Piece>& GetPieces() const { return this->Pieces; }
  /// Returns the starts of the pieces, one more than pieces: the last is beyond every value.
  const std::vector<float>& GetStarts() const { return this->Starts; }

  /// Returns the fourth of value and slope of each piece, for loops that need no more.
  const std::vector<float>& GetExtinctions() const { return this->Extinctions; }
  const std::vector<float>& GetExtinctionSlopes() const { return this->ExtinctionSlopes; }
  /// Returns for each of 1024 + 1 values of the scalar the piece it lies in.
  const std::vector<int>& GetBuckets() const { return this->First; }

  /// Returns the piece that \a f, 0 to 1, lies in.
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

  /// Returns whether every value gives the same colour, whatever its extinction.
  bool HasOneColor() const;

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
  /// The piece that each of BUCKETS + 1 values of f lies in.
  std::vector<int> First;
};

}

#endif
