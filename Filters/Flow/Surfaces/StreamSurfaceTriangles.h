// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_StreamSurfaceTriangles_h
#define interlume_StreamSurfaceTriangles_h

#include "Common/Error.h"
#include "Samples/ImplicitFlowArrays.h"
#include "Surfaces/ContourLocator.h"

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
 * @brief   assigns triangles of a stream surface to contours, and their points to positions along
 * the contours
 */
class StreamSurfaceTriangles
{
public:
  using Triangle = std::array<vtkIdType, 3>;

  /// Contours of one Inflow value on one termination surface.
  struct Level
  {
    int Id = 0;
    double Value = 0.0;
    /// ContourId of the level's first contour; the others follow.
    int FirstContour = 0;
    std::unique_ptr<ContourLocator> Locator;
  };

  struct Contour
  {
    double Length;
    bool IsClosed;
  };

  /// Points of the output: the points of the input, followed by copies.
  struct Points
  {
    std::vector<vtkIdType> Sources;
    std::vector<int> Contours;
    std::vector<double> Lengths;

    vtkIdType Add(vtkIdType source, int contour, double length);
  };

  /// Reads the triangles, the arrays and the levels in use. Returns an error if they cannot be
  /// used.
  Error Read(vtkPointSet* input);

  vtkIdType GetNumberOfPoints() const { return static_cast<vtkIdType>(this->LevelOfPoint.size()); }
  const ImplicitFlowArrays& GetArrays() const { return this->Arrays; }

  /// Finds the position of a point on the contours of its level. Thread-safe for different points.
  void Locate(vtkIdType point);

  /**
   * Creates the triangles of the output. Copies of points ensure that the corners of each triangle
   * lie on one contour, and on one side of the contour's start. The position of a copy is the
   * original's position plus the contour's length, or is on another contour.
   */
  Points MakeTriangles(vtkCellArray* cells) const;

  /// Levels. The caller sets their contours between Read and Locate.
  std::vector<Level> Levels;
  /// Contours by ContourId.
  std::vector<Contour> Contours;

private:
  struct Corner
  {
    ContourLocator::Location Location;
    // True if the contour's length is added to the position.
    bool IsShifted = false;
  };

  void FindLevels(vtkDataArray* values, vtkIdType numberOfPoints);
  int GetContourId(int level, int curve) const;
  /// Finds the position of a point on a curve of a level; on any curve if \a curve is -1.
  ContourLocator::Location Locate(int level, vtkIdType point, int curve) const;
  /// Returns the corners of a triangle on one contour, unwrapped.
  std::array<Corner, 3> Unwrap(std::size_t triangle) const;

  ImplicitFlowArrays Arrays;
  std::vector<Triangle> Triangles;
  // Index of the level of each triangle, and of each point (from its first triangle; -1 if unused).
  std::vector<int> LevelOfTriangle;
  std::vector<int> LevelOfPoint;
  // Position of each point on the contours of its level.
  std::vector<ContourLocator::Location> Locations;
};

}

#endif
