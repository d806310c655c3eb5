// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_BoxWalker_h
#define interlume_BoxWalker_h

#include "Fields/CellWalker.h"
#include "Fields/IndexedFlowField.h"
#include "Fields/SimdBoxWalker.h"

namespace interlume
{

/**
 * @class   BoxWalker
 * @brief   walker for box cells, in images and rectilinear grids
 *
 * In a box dx/dp is constant, so dp/dt is a trilinear polynomial. Its coefficients are computed
 * when a cell is entered. \a FieldType is ImageFlowField or RectilinearFlowField.
 */
template <typename FieldType>
class BoxWalker : public CellWalker
{
public:
  using Field = FieldType;
  /// Walker that is in several cells at once, one per SIMD lane.
  template <typename SimdPack>
  using SimdWalker = SimdBoxWalker<FieldType, SimdPack>;
  static constexpr bool HasSimdWalker = true;

  explicit BoxWalker(const Field* field)
    : Shared(field)
  {
  }

  const Field& GetField() const { return *this->Shared; }

  const typename Field::CellLocation& GetCellLocation() const { return this->Stand; }
  /// Returns the trilinear dp/dt of the cell.
  const Trilinear& GetRate() const { return this->Rate; }
  bool IsHere() const { return this->Shared->IsHere(this->Stand); }
  /// Enters a cell of the field, which need not be a neighbor of the current cell.
  void GoTo(vtkIdType cell)
  {
    this->Stand = this->Shared->GetCellLocation(cell);
    this->Enter();
  }
  /// Enters a cell of the field unless the walker is already in it.
  void StandIn(const typename Field::CellLocation& location)
  {
    if (location.Cell != this->Stand.Cell)
    {
      this->Stand = location;
      this->Enter();
    }
  }

  bool Locate(const double x[3], double p[3])
  {
    if (!this->Shared->Locate(x, this->Stand, p))
    {
      return false;
    }
    this->Enter();
    return true;
  }
  bool LocateNearby(const double x[3], double p[3]) { return this->Locate(x, p); }

  vtkIdType GetCell() const { return this->Stand.Cell; }
  bool IsFinite() const { return this->HasFiniteVectors; }

  void GetVelocity(const double p[3], double rate[3]) const { this->Rate.Evaluate(p, rate); }

  void GetJacobian(const double p[3], double jacobian[9]) const
  {
    double columns[3][4];
    this->Rate.EvaluateDerivatives(p, columns);
    for (int i = 0; i < 9; ++i)
    {
      jacobian[i] = columns[i % 3][i / 3];
    }
  }

  void GetPosition(const double p[3], double x[3]) const
  {
    this->Shared->GetPosition(this->Stand, p, x);
  }

  void GetWorldVector(const double*, const double d[3], double w[3]) const
  {
    double frame[9];
    this->Shared->GetFrame(this->Stand, frame);
    const double from[3] = { d[0], d[1], d[2] };
    for (int i = 0; i < 3; ++i)
    {
      w[i] = frame[3 * i] * from[0] + frame[3 * i + 1] * from[1] + frame[3 * i + 2] * from[2];
    }
  }

  void GetVelocityGradient(const double p[3], double gradient[9]) const
  {
    double frame[9];
    double inverse[9];
    double columns[3][4];
    this->Shared->GetFrame(this->Stand, frame);
    this->Shared->GetInverse(this->Stand, inverse);
    this->Rate.EvaluateDerivatives(p, columns);
    for (int i = 0; i < 3; ++i)
    {
      double row[3];
      for (int j = 0; j < 3; ++j)
      {
        row[j] = frame[3 * i] * columns[j][0] + frame[3 * i + 1] * columns[j][1] +
          frame[3 * i + 2] * columns[j][2];
      }
      for (int j = 0; j < 3; ++j)
      {
        gradient[3 * i + j] =
          row[0] * inverse[j] + row[1] * inverse[3 + j] + row[2] * inverse[6 + j];
      }
    }
  }

  static constexpr bool IsBox() { return true; }
  int GetNumberOfFaces() const { return 6; }
  double GetFaceDistance(int face, const double p[3]) const
  {
    const double q = p[face >> 1];
    return face & 1 ? 1.0 - q : q;
  }

  void Prefetch(int face, int round) const
  {
    if (round == 0)
    {
      this->Shared->Prefetch(this->Stand, face);
    }
  }
  bool Cross(int face, double p[3])
  {
    if (!this->Shared->Step(this->Stand, face))
    {
      return false;
    }
    p[face >> 1] = face & 1 ? 0.0 : 1.0;
    this->Enter();
    return true;
  }

  bool HasNeighbor(int face) const
  {
    typename Field::CellLocation location = this->Stand;
    return this->Shared->Step(location, face);
  }
  FaceExtent GetFaceExtent(int face) const
  {
    const int axis = face >> 1;
    double frame[9];
    this->Shared->GetFrame(this->Stand, frame);
    // Corners of the face relative to its first corner.
    double corners[4][3];
    double opposite[3];
    for (int i = 0; i < 3; ++i)
    {
      const double u = frame[3 * i + (axis + 1) % 3];
      const double v = frame[3 * i + (axis + 2) % 3];
      corners[0][i] = 0.0;
      corners[1][i] = u;
      corners[2][i] = u + v;
      corners[3][i] = v;
      opposite[i] = frame[3 * i + axis];
    }
    return FaceExtent::Of(corners, 4, &opposite, 1);
  }

  int GetDomainFace(int face) const
  {
    return this->Shared->IsOutside(this->Stand, face) ? face : -1;
  }
  void GetDomainParameters(int face, const double p[3], double uv[2]) const
  {
    this->Shared->GetParameters(this->Stand, face, p, uv);
  }

  double Interpolate(int array, const double p[3]) const
  {
    Trilinear values;
    this->Shared->GetValues(array, this->Stand, values);
    values.Fit();
    double value[3];
    values.Evaluate(p, value);
    return value[0];
  }

private:
  void Enter()
  {
    double inverse[9];
    this->Shared->GetInverse(this->Stand, inverse);
    // Rows have four elements so that compilers vectorize the loop.
    double columns[3][4];
    for (int i = 0; i < 12; ++i)
    {
      columns[i >> 2][i & 3] = (i & 3) < 3 ? inverse[3 * (i & 3) + (i >> 2)] : 0.0;
    }
    double check = 0.0;
    for (int corner = 0; corner < 8; ++corner)
    {
      double v[3];
      this->Shared->GetVector(this->Shared->GetCorner(this->Stand, corner), v);
      double* rate = this->Rate.C[corner];
      // The sum becomes NaN if a component is not finite.
      check += 0.0 * v[0] + 0.0 * v[1] + 0.0 * v[2];
      for (int i = 0; i < 4; ++i)
      {
        rate[i] = columns[0][i] * v[0] + columns[1][i] * v[1] + columns[2][i] * v[2];
      }
    }
    this->HasFiniteVectors = check == 0.0;
    this->Rate.Fit();
  }

  const Field* Shared;
  typename Field::CellLocation Stand;
  bool HasFiniteVectors = false;
  Trilinear Rate = {};
};

}

#endif
