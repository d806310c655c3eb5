// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceBoundary_h
#define ReferenceBoundary_h

#include <array>  // for points
#include <vector> // for faces

class vtkDataSet;

namespace reference
{

/**
 * @class   DomainBoundary
 * @brief   faces of a mesh that belong to a single cell
 *
 * Faces must be planar and convex. Whether a point lies in a face is tested with a tolerance of
 * 1e-10 times the size of the mesh.
 */
class DomainBoundary
{
public:
  using Point = std::array<double, 3>;

  explicit DomainBoundary(vtkDataSet* mesh);

  int GetNumberOfFaces() const { return static_cast<int>(this->Faces.size()); }
  /// Returns the index of the first face that contains all \a points, or -1.
  int Find(const std::vector<Point>& points) const;
  double GetArea(int face) const { return this->Faces[face].Area; }
  /// Returns the area of a triangle in a face, negative if its normal points into the mesh.
  double SignedArea(int face, const std::vector<Point>& triangle) const;

private:
  struct Face
  {
    std::vector<Point> Corners;
    Point Normal; ///< outward, of length 1
    double Area;
  };

  bool Holds(const Face& face, const Point& point) const;

  std::vector<Face> Faces;
  double Tolerance;
};

}

#endif
