// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_LatticeLanes_h
#define interlume_LatticeLanes_h

#include "Common/Lanes.h"
#include "Fields/IndexedFlowField.h"

namespace interlume
{

/**
 * @class   LatticeLanes
 * @brief   several walkers of boxes that go together
 *
 * What LatticeWalker computes for one place this computes for a place in each of several cells,
 * with the same bytes but for the sign of zeros that make no difference. \a FieldType is
 * ImageFlowField or RectilinearFlowField.
 */
template <typename FieldType, typename LaneType>
class LatticeLanes
{
public:
  using Field = FieldType;
  using Lanes = LaneType;
  using Mask = typename Lanes::Mask;
  using Place = typename Field::Place;

  explicit LatticeLanes(const Field* field)
    : Shared(field)
  {
    // Lanes that nothing stands in are in the first cell, which may be read like any other.
    this->Enter();
  }

  /// Stands in a cell without computing what is known of it, which Enter does for all.
  void Stand(int lane, const Place& place) { this->Stands[lane] = place; }
  /// Stands where another walker does, with all that this knows.
  template <typename Walker>
  void StandAs(int lane, const Walker& walker)
  {
    this->Stand(lane, walker.GetPlace());
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
  const Place& GetPlace(int lane) const { return this->Stands[lane]; }
  vtkIdType GetCell(int lane) const { return this->Stands[lane].Cell; }

  /// Prefetches what the cell beyond a face has and the own has not.
  [[gnu::always_inline]] void Prefetch(int lane, int face) const
  {
    this->Shared->Prefetch(this->Stands[lane], face);
  }

  /// Goes to the cell beyond a face as Stand does. Returns false where there is none to go on in.
  [[gnu::always_inline]] bool Step(int lane, int face)
  {
    return this->Shared->StepHere(this->Stands[lane], face);
  }

  /// Computes the velocities and frames of all cells. Returns the lanes whose vectors are finite.
  [[gnu::always_inline]] Mask Enter()
  {
    this->FindFrames();
    const auto& rows = this->Shared->GetVectorRows();
    return rows.GetFloats() ? this->EnterFrom(rows.GetFloats())
                            : this->EnterFrom(rows.GetDoubles());
  }

  /// Computes dp/dt.
  [[gnu::always_inline]] void GetVelocity(const Lanes p[3], Lanes rate[3]) const
  {
    const Lanes& x = p[0];
    const Lanes& y = p[1];
    const Lanes& z = p[2];
    const auto& c = this->C;
    for (int i = 0; i < 3; ++i)
    {
      rate[i] = ((c[0][i] + x * c[1][i]) + y * (c[2][i] + x * c[3][i])) +
        z * ((c[4][i] + x * c[5][i]) + y * (c[6][i] + x * c[7][i]));
    }
  }

  [[gnu::always_inline]] void GetWorldVector(const Lanes*, const Lanes d[3], Lanes w[3]) const
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
    double frames[Lanes::Number][9];
    double inverses[Lanes::Number][9];
    for (int lane = 0; lane < Lanes::Number; ++lane)
    {
      this->Shared->GetFrame(this->Stands[lane], frames[lane]);
      this->Shared->GetInverse(this->Stands[lane], inverses[lane]);
    }
    this->IsDiagonal = true;
    for (int i = 0; i < 9; ++i)
    {
      this->Frame[i] = Lanes::OfEach([&](int lane) { return frames[lane][i]; });
      this->Inverse[i] = Lanes::OfEach([&](int lane) { return inverses[lane][i]; });
      const bool isZero = frames[0][i] == 0.0 && inverses[0][i] == 0.0;
      this->IsDiagonal = this->IsDiagonal && (i % 4 == 0 || isZero);
    }
  }

  template <typename Real>
  [[gnu::always_inline]] Mask EnterFrom(const Real* vectors)
  {
    Lanes check = Lanes::Of(0.0);
    for (int corner = 0; corner < 8; ++corner)
    {
      const Real* v[Lanes::Number];
      for (int lane = 0; lane < Lanes::Number; ++lane)
      {
        v[lane] = vectors + 3 * this->Shared->GetCorner(this->Stands[lane], corner);
      }
      Lanes vector[3];
      for (int i = 0; i < 3; ++i)
      {
        vector[i] = Lanes::OfEach([&](int lane) { return v[lane][i]; });
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
    // The sum of numbers that are not all finite is not finite.
    return 0.0 * check == Lanes::Of(0.0);
  }

  const Field* Shared;
  Place Stands[Lanes::Number];
  /// As in Trilinear.
  Lanes C[8][3];
  Lanes Frame[9];
  Lanes Inverse[9];
  bool IsDiagonal = false;
  bool HasFrames = false;
};

}

#endif
