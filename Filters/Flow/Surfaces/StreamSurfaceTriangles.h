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
    /// ContourId of the level's first contour. The ids of the level's contours are consecutive.
    int FirstContour = 0;
    std::unique_ptr<ContourLocator> Locator;
  };

  struct Contour
  {
    double Length;
    bool IsClosed;
  };

  /// Points of the output: the points of the input, followed by copies of some of them.
  struct Points
  {
    std::vector<vtkIdType> Sources;
    std::vector<int> Contours;
    std::vector<double> Lengths;

    vtkIdType Add(vtkIdType source, int contour, double length);
  };

  /// Reads the triangles and arrays, and finds the levels. Returns an error if the input is
  /// invalid.
  Error Read(vtkPointSet* input);

  vtkIdType GetNumberOfPoints() const { return static_cast<vtkIdType>(this->LevelOfPoint.size()); }
  const ImplicitFlowArrays& GetArrays() const { return this->Arrays; }

  /// Finds the position of a point on the contours of its level. Thread-safe for different points.
  void Locate(vtkIdType point);

  /**
   * Creates the triangles of the output. Points are copied so that the corners of each triangle lie
   * on the same contour, and no triangle extends across the start of a closed contour. A copy is on
   * a different contour from the original, or its position is greater by the contour's length.
   */
  Points MakeTriangles(vtkCellArray* cells) const;

  /// Levels that Read found. The caller must set their contours before it calls Locate.
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
  /// Returns the positions of a triangle's corners on one contour, unwrapped at its start.
  std::array<Corner, 3> Unwrap(std::size_t triangle) const;

  ImplicitFlowArrays Arrays;
  std::vector<Triangle> Triangles;
  // Index of each triangle's level, and of each point's level: the level of the first triangle that
  // uses the point, or -1 if there is none.
  std::vector<int> LevelOfTriangle;
  std::vector<int> LevelOfPoint;
  // Position of each point on the contours of its level.
  std::vector<ContourLocator::Location> Locations;
};

}

#endif
