// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_StreamSurfaceTriangles_h
#define interlume_StreamSurfaceTriangles_h

#include "Common/Error.h"
#include "Samples/ImplicitFlowArrays.h"
#include "Surfaces/ContourPlaces.h"

#include "vtkType.h"

#include <array>
#include <memory>
#include <vector>

class vtkCellArray;
class vtkPointSet;

namespace interlume
{

/**
 * @class   StreamSurfaceTriangles
 * @brief   the triangles of a stream surface, the contours they belong to, and their places there
 */
class StreamSurfaceTriangles
{
public:
  using Triangle = std::array<vtkIdType, 3>;

  /// The contours of one value on the surface of one id.
  struct Level
  {
    int Id = 0;
    double Value = 0.0;
    /// The ContourId of the level's first contour; the others follow.
    int FirstContour = 0;
    std::unique_ptr<ContourPlaces> Places;
  };

  struct Contour
  {
    double Length;
    bool IsClosed;
  };

  /// The points of an output: those of the input, and copies.
  struct Points
  {
    std::vector<vtkIdType> Sources;
    std::vector<int> Contours;
    std::vector<double> Lengths;

    vtkIdType Add(vtkIdType source, int contour, double length);
  };

  /// Takes the triangles, the arrays and the levels in use. Returns an error if they cannot be
  /// used.
  Error Read(vtkPointSet* input);

  vtkIdType GetNumberOfPoints() const { return static_cast<vtkIdType>(this->LevelOfPoint.size()); }
  const ImplicitFlowArrays& GetArrays() const { return this->Arrays; }

  /// Finds the place of a point on the contours of its level, by threads.
  void FindPlace(vtkIdType point);

  /**
   * Gives triangles their points, with copies so that the corners of each are on one contour and
   * none on the far side of its start: a point stands for its own place, copies for that place a
   * whole length on, or on another contour.
   */
  Points MakeTriangles(vtkCellArray* cells) const;

  /// The levels, which are to be given contours between Read and FindPlace.
  std::vector<Level> Levels;
  /// The contours by ContourId.
  std::vector<Contour> Contours;

private:
  struct Corner
  {
    ContourPlaces::Place Place;
    // Whether a whole length of the contour is added.
    bool IsShifted = false;
  };

  void FindLevels(vtkDataArray* values, vtkIdType numberOfPoints);
  int GetContourId(int level, int curve) const;
  /// Finds the place of a point on a curve of a level; on any curve for -1.
  ContourPlaces::Place FindPlace(int level, vtkIdType point, int curve) const;
  /// Returns the corners of a triangle on one contour, unwrapped.
  std::array<Corner, 3> Unwrap(std::size_t triangle) const;

  ImplicitFlowArrays Arrays;
  std::vector<Triangle> Triangles;
  // The level of each triangle, and of each point by the first of its triangles, or -1.
  std::vector<int> LevelOfTriangle;
  std::vector<int> LevelOfPoint;
  // The place of each point on the contours of its level.
  std::vector<ContourPlaces::Place> Places;
};

}

#endif
