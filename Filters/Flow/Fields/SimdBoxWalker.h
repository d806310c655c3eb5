// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SimdBoxWalker_h
#define interlume_SimdBoxWalker_h

#include "Common/SimdPack.h"
#include "Fields/IndexedFlowField.h"

namespace interlume
{

/**
 * @class   SimdBoxWalker
 * @brief   walker in several box cells at once, with SIMD instructions
 *
 * Each SIMD lane is at a position in its own cell. Results are bit-identical to those of BoxWalker,
 * except for the signs of zeros that do not affect results. \a FieldType is ImageFlowField or
 * RectilinearFlowField.
 */
template <typename FieldType, typename Pack>
class SimdBoxWalker
{
public:
  using Field = FieldType;
  using SimdPack = Pack;
  using Mask = typename SimdPack::Mask;
  using CellLocation = typename Field::CellLocation;

  explicit SimdBoxWalker(const Field* field)
    : Shared(field)
  {
    // Unused SIMD lanes are in the first cell, which is safe to read.
    this->Enter();
  }

  /// Moves a SIMD lane to a cell. Call Enter() afterward to compute the velocities.
  void MoveLane(int lane, const CellLocation& location) { this->Stands[lane] = location; }
  /// Copies the cell, frame and velocities of another walker to a SIMD lane.
  template <typename Walker>
  void CopyFrom(int lane, const Walker& walker)
  {
    this->MoveLane(lane, walker.GetCellLocation());
    if (!Field::HasOneFrame)
    {
      double frame[9];
      double inverse[9];
      this->Shared->GetFrame(this->Stands[lane], frame);
      this->Shared->GetInverse(this->Stands[lane], inverse);
      for (int i = 0; i < 9; ++i)
      {
        this->Frame[i].Set(lane, frame[i]);
        this->Inverse[i].Set(lane, inverse[i]);
      }
    }
    const Trilinear& rate = walker.GetRate();
    for (int m = 0; m < 8; ++m)
    {
      for (int i = 0; i < 3; ++i)
      {
        this->C[m][i].Set(lane, rate.C[m][i]);
      }
    }
  }
  void GetPosition(int lane, const double p[3], double x[3]) const
  {
    this->Shared->GetPosition(this->Stands[lane], p, x);
  }
  const CellLocation& GetCellLocation(int lane) const { return this->Stands[lane]; }
  vtkIdType GetCell(int lane) const { return this->Stands[lane].Cell; }

  /// Prefetches the vectors of the cell across a face, except at the corners on the face.
  [[gnu::always_inline]] void Prefetch(int lane, int face) const
  {
    this->Shared->Prefetch(this->Stands[lane], face);
  }

  /// Moves a SIMD lane to the cell across a face. Call Enter() afterward, as after MoveLane().
  /// Returns false if this process has no such cell.
  [[gnu::always_inline]] bool Step(int lane, int face)
  {
    return this->Shared->StepHere(this->Stands[lane], face);
  }

  /// Computes the velocities and frames of all SIMD lanes. Returns a mask of the lanes whose
  /// vectors are finite.
  [[gnu::always_inline]] Mask Enter()
  {
    this->FindFrames();
    const auto& rows = this->Shared->GetVectorRows();
    return rows.GetFloats() ? this->EnterFrom(rows.GetFloats())
                            : this->EnterFrom(rows.GetDoubles());
  }

  /// Computes dp/dt.
  [[gnu::always_inline]] void GetVelocity(const SimdPack p[3], SimdPack rate[3]) const
  {
    const SimdPack& x = p[0];
    const SimdPack& y = p[1];
    const SimdPack& z = p[2];
    const auto& c = this->C;
    for (int i = 0; i < 3; ++i)
    {
      rate[i] = ((c[0][i] + x * c[1][i]) + y * (c[2][i] + x * c[3][i])) +
        z * ((c[4][i] + x * c[5][i]) + y * (c[6][i] + x * c[7][i]));
    }
  }

  [[gnu::always_inline]] void GetWorldVector(
    const SimdPack*, const SimdPack d[3], SimdPack w[3]) const
  {
    if (this->IsDiagonal)
    {
      for (int i = 0; i < 3; ++i)
      {
        w[i] = this->Frame[4 * i] * d[i];
      }
      return;
    }
    for (int i = 0; i < 3; ++i)
    {
      w[i] =
        this->Frame[3 * i] * d[0] + this->Frame[3 * i + 1] * d[1] + this->Frame[3 * i + 2] * d[2];
    }
  }

private:
  [[gnu::always_inline]] void FindFrames()
  {
    if (this->HasFrames && Field::HasOneFrame)
    {
      return;
    }
    this->HasFrames = true;
    double frames[SimdPack::Number][9];
    double inverses[SimdPack::Number][9];
    for (int lane = 0; lane < SimdPack::Number; ++lane)
    {
      this->Shared->GetFrame(this->Stands[lane], frames[lane]);
      this->Shared->GetInverse(this->Stands[lane], inverses[lane]);
    }
    this->IsDiagonal = true;
    for (int i = 0; i < 9; ++i)
    {
      this->Frame[i] = SimdPack::OfEach([&](int lane) { return frames[lane][i]; });
      this->Inverse[i] = SimdPack::OfEach([&](int lane) { return inverses[lane][i]; });
      const bool isZero = frames[0][i] == 0.0 && inverses[0][i] == 0.0;
      this->IsDiagonal = this->IsDiagonal && (i % 4 == 0 || isZero);
    }
  }

  template <typename Real>
  [[gnu::always_inline]] Mask EnterFrom(const Real* vectors)
  {
    SimdPack check = SimdPack::Of(0.0);
    for (int corner = 0; corner < 8; ++corner)
    {
      const Real* v[SimdPack::Number];
      for (int lane = 0; lane < SimdPack::Number; ++lane)
      {
        v[lane] = vectors + 3 * this->Shared->GetCorner(this->Stands[lane], corner);
      }
      SimdPack vector[3];
      for (int i = 0; i < 3; ++i)
      {
        vector[i] = SimdPack::OfEach([&](int lane) { return v[lane][i]; });
        check = check + vector[i];
      }
      for (int i = 0; i < 3; ++i)
      {
        this->C[corner][i] = this->IsDiagonal ? this->Inverse[4 * i] * vector[i]
                                              : this->Inverse[3 * i] * vector[0] +
            this->Inverse[3 * i + 1] * vector[1] + this->Inverse[3 * i + 2] * vector[2];
      }
    }
    for (int bit = 1; bit < 8; bit *= 2)
    {
      for (int m = 0; m < 8; ++m)
      {
        for (int i = 0; i < 3 && (m & bit); ++i)
        {
          this->C[m][i] = this->C[m][i] - this->C[m ^ bit][i];
        }
      }
    }
    // The sum is finite only if all vectors are finite.
    return 0.0 * check == SimdPack::Of(0.0);
  }

  const Field* Shared;
  CellLocation Stands[SimdPack::Number];
  /// Coefficients of dp/dt, as in Trilinear.
  SimdPack C[8][3];
  SimdPack Frame[9];
  SimdPack Inverse[9];
  bool IsDiagonal = false;
  bool HasFrames = false;
};

}

#endif
