// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_CellShape_h
#define interlume_CellShape_h

#include "Cells/Trilinear.h"

namespace interlume
{

/**
 * @class   CellShape
 * @brief   corners, faces and parametric coordinates of the cell types that streamlines traverse
 *
 * All cells interpolate as VTK cells do. Their parametric coordinates p = (x, y, z) are chosen such
 * that position and vectors are trilinear polynomials of p and faces are planes:
 *
 * - HEXAHEDRON: corners of [0,1]^3, x varies fastest. Also used for voxels.
 * - TETRAHEDRON: corners (0,0,0), (1,0,0), (0,1,0), (0,0,1). Linear.
 * - WEDGE: corners (0,0,0), (1,0,0), (0,1,0), and the same at z = 1.
 * - PYRAMID: base (0,0,0), (1,0,0), (1,1,0), (0,1,0), apex (0,0,1); 0 <= x, y <= 1 - z. The term xy
 *   is replaced by x y / (1 - z). VTK's parametric coordinates are r = x / (1 - z), s = y / (1 - z)
 *   and t = z; dx/dr and dx/ds vanish at the apex. In (x, y, z), dx/dp remains bounded and has a
 *   limit along each line to the apex. At the apex and past it, r and s are clamped to [-1, 2].
 */
struct CellShape
{
  enum Kinds
  {
    HEXAHEDRON = 0,
    TETRAHEDRON = 1,
    WEDGE = 2,
    PYRAMID = 3
  };

  /**
   * Face with coordinates (u,v). Corner 0 is at (0,0), corner 1 at (1,0), and the last corner at
   * (0,1). In a triangle, the weights of the corners are 1-u-v, u and v. In a quadrilateral, corner
   * 2 is at (1,1).
   */
  struct Face
  {
    int NumberOfCorners = 0;
    int Corners[4] = { 0, 0, 0, 0 };
    /// Distance to the face as a function of p: Plane[3] plus the dot product of Plane[0..2] and p.
    double Plane[4] = { 0, 0, 0, 0 };
    /// Parametric coordinates of (u,v): Origin + u U + v V.
    double Origin[3] = { 0, 0, 0 };
    double U[3] = { 0, 0, 0 };
    double V[3] = { 0, 0, 0 };
    /// u and v as affine functions of p, in the same format as Plane.
    double UOf[4] = { 0, 0, 0, 0 };
    double VOf[4] = { 0, 0, 0, 0 };

    static double Apply(const double plane[4], const double p[3])
    {
      return plane[3] + (plane[0] * p[0] + plane[1] * p[1] + plane[2] * p[2]);
    }
    double GetDistance(const double p[3]) const { return Apply(this->Plane, p); }
    void GetParameters(const double p[3], double uv[2]) const
    {
      uv[0] = Apply(this->UOf, p);
      uv[1] = Apply(this->VOf, p);
    }
    void GetCoordinates(const double uv[2], double p[3]) const
    {
      for (int i = 0; i < 3; ++i)
      {
        p[i] = this->Origin[i] + (uv[0] * this->U[i] + uv[1] * this->V[i]);
      }
    }
  };

  Kinds Kind = HEXAHEDRON;
  int NumberOfCorners = 0;
  int NumberOfFaces = 0;
  double Corners[8][3] = {};
  double Center[3] = { 0, 0, 0 };
  Face Faces[6] = {};

  static const CellShape& Of(int kind);

  /// Converts values at the corners to the coefficients of the interpolating polynomial.
  static void Fit(int kind, Trilinear& values)
  {
    auto& c = values.C;
    switch (kind)
    {
      case TETRAHEDRON:
        CopyRow(values, 3, 4);
        break;
      case WEDGE:
        // The wedge is fitted as a hexahedron whose values at x = y = 1 are extrapolated linearly,
        // so the coefficients of xy and xyz are 0.
        CopyRow(values, 5, 6);
        CopyRow(values, 4, 5);
        CopyRow(values, 3, 4);
        values.Subtract(6, 4);
        values.Subtract(5, 4);
        values.Subtract(4, 0);
        values.Subtract(2, 0);
        values.Subtract(1, 0);
        values.Subtract(6, 2);
        values.Subtract(5, 1);
        values.Clear(3);
        values.Clear(7);
        return;
      case PYRAMID:
        for (int i = 0; i < 4; ++i)
        {
          const double last = c[3][i];
          c[3][i] = (c[0][i] - c[1][i]) + (c[2][i] - last);
          c[2][i] = last;
        }
        break;
      default:
        values.Fit();
        return;
    }
    values.Subtract(4, 0);
    values.Subtract(2, 0);
    values.Subtract(1, 0);
    if (kind == TETRAHEDRON)
    {
      values.Clear(3);
    }
    for (int row = 5; row < 8; ++row)
    {
      values.Clear(row);
    }
  }

private:
  static void CopyRow(Trilinear& values, int from, int to)
  {
    for (int i = 0; i < 4; ++i)
    {
      values.C[to][i] = values.C[from][i];
    }
  }

  constexpr void AddFace(int corners, const int (&ids)[4], const double (&plane)[4])
  {
    Face& face = this->Faces[this->NumberOfFaces++];
    face.NumberOfCorners = corners;
    for (int i = 0; i < 4; ++i)
    {
      face.Corners[i] = ids[i];
      face.Plane[i] = plane[i];
    }
    for (int i = 0; i < 3; ++i)
    {
      const double origin = this->Corners[ids[0]][i];
      face.Origin[i] = origin;
      face.U[i] = this->Corners[ids[1]][i] - origin;
      face.V[i] = this->Corners[ids[corners - 1]][i] - origin;
    }
    FindDual(face.Origin, face.U, face.V, face.UOf);
    FindDual(face.Origin, face.V, face.U, face.VOf);
  }

  // Computes the affine function that is 0 at \a origin, increases by 1 along the vector \a along
  // and is constant along \a across. For all faces of all shapes, this function depends on a single
  // coordinate of p.
  static constexpr void FindDual(
    const double* origin, const double* along, const double* across, double* dual)
  {
    for (int axis = 2; axis >= 0; --axis)
    {
      if (along[axis] != 0.0 && across[axis] == 0.0)
      {
        for (int i = 0; i < 3; ++i)
        {
          dual[i] = i == axis ? along[axis] : 0.0;
        }
        dual[3] = -origin[axis] * along[axis];
        return;
      }
    }
  }

  constexpr void AddCorner(double x, double y, double z)
  {
    double* corner = this->Corners[this->NumberOfCorners++];
    corner[0] = x;
    corner[1] = y;
    corner[2] = z;
  }

  constexpr void SetCenter(double x, double y, double z)
  {
    this->Center[0] = x;
    this->Center[1] = y;
    this->Center[2] = z;
  }

  static constexpr CellShape MakeHexahedron();
  static constexpr CellShape MakeTetrahedron();
  static constexpr CellShape MakeWedge();
  static constexpr CellShape MakePyramid();
};

constexpr CellShape CellShape::MakeHexahedron()
{
  CellShape shape;
  shape.Kind = HEXAHEDRON;
  for (int v = 0; v < 8; ++v)
  {
    shape.AddCorner(v & 1, v >> 1 & 1, v >> 2);
  }
  shape.AddFace(4, { 0, 2, 6, 4 }, { 1, 0, 0, 0 });
  shape.AddFace(4, { 1, 3, 7, 5 }, { -1, 0, 0, 1 });
  shape.AddFace(4, { 0, 1, 5, 4 }, { 0, 1, 0, 0 });
  shape.AddFace(4, { 2, 3, 7, 6 }, { 0, -1, 0, 1 });
  shape.AddFace(4, { 0, 1, 3, 2 }, { 0, 0, 1, 0 });
  shape.AddFace(4, { 4, 5, 7, 6 }, { 0, 0, -1, 1 });
  shape.SetCenter(0.5, 0.5, 0.5);
  return shape;
}

constexpr CellShape CellShape::MakeTetrahedron()
{
  CellShape shape;
  shape.Kind = TETRAHEDRON;
  shape.AddCorner(0, 0, 0);
  shape.AddCorner(1, 0, 0);
  shape.AddCorner(0, 1, 0);
  shape.AddCorner(0, 0, 1);
  shape.AddFace(3, { 0, 2, 3, 0 }, { 1, 0, 0, 0 });
  shape.AddFace(3, { 0, 1, 3, 0 }, { 0, 1, 0, 0 });
  shape.AddFace(3, { 0, 1, 2, 0 }, { 0, 0, 1, 0 });
  shape.AddFace(3, { 1, 2, 3, 0 }, { -1, -1, -1, 1 });
  shape.SetCenter(0.25, 0.25, 0.25);
  return shape;
}

constexpr CellShape CellShape::MakeWedge()
{
  CellShape shape;
  shape.Kind = WEDGE;
  for (int z = 0; z < 2; ++z)
  {
    shape.AddCorner(0, 0, z);
    shape.AddCorner(1, 0, z);
    shape.AddCorner(0, 1, z);
  }
  shape.AddFace(4, { 0, 2, 5, 3 }, { 1, 0, 0, 0 });
  shape.AddFace(4, { 0, 1, 4, 3 }, { 0, 1, 0, 0 });
  shape.AddFace(4, { 1, 2, 5, 4 }, { -1, -1, 0, 1 });
  shape.AddFace(3, { 0, 1, 2, 0 }, { 0, 0, 1, 0 });
  shape.AddFace(3, { 3, 4, 5, 0 }, { 0, 0, -1, 1 });
  shape.SetCenter(1.0 / 3.0, 1.0 / 3.0, 0.5);
  return shape;
}

constexpr CellShape CellShape::MakePyramid()
{
  CellShape shape;
  shape.Kind = PYRAMID;
  shape.AddCorner(0, 0, 0);
  shape.AddCorner(1, 0, 0);
  shape.AddCorner(1, 1, 0);
  shape.AddCorner(0, 1, 0);
  shape.AddCorner(0, 0, 1);
  shape.AddFace(3, { 0, 3, 4, 0 }, { 1, 0, 0, 0 });
  shape.AddFace(3, { 0, 1, 4, 0 }, { 0, 1, 0, 0 });
  shape.AddFace(3, { 1, 2, 4, 0 }, { -1, 0, -1, 1 });
  shape.AddFace(3, { 3, 2, 4, 0 }, { 0, -1, -1, 1 });
  shape.AddFace(4, { 0, 1, 2, 3 }, { 0, 0, 1, 0 });
  shape.SetCenter(0.4, 0.4, 0.2);
  return shape;
}

inline const CellShape& CellShape::Of(int kind)
{
  static constexpr CellShape shapes[4] = { MakeHexahedron(), MakeTetrahedron(), MakeWedge(),
    MakePyramid() };
  return shapes[kind];
}

}

#endif
