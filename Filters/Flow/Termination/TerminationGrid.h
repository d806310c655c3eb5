// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TerminationGrid_h
#define interlume_TerminationGrid_h

#include "vtkType.h"

#include <array>
#include <vector>

class vtkAlgorithm;
class vtkTerminationSurface;

namespace interlume
{

/**
 * @class   TerminationGrid
 * @brief   a grid over the parameters of one part of a termination surface, cut where the part ends
 */
class TerminationGrid
{
public:
  struct Point
  {
    double Parameters[2];
    double Position[3];
    double Normal[3];
  };

  TerminationGrid(const vtkTerminationSurface* surface, int part, int columns, int rows);

  /// Makes points and triangles, by threads; the progress of \a owner goes from \a start to \a end.
  /// Returns false when its execution was aborted.
  bool Execute(vtkAlgorithm* owner, double start, double end);

  std::vector<Point> Points;
  std::vector<std::array<vtkIdType, 3>> Triangles;
  /// The number of points on the part's border that are no node of the grid.
  vtkIdType BorderPoints = 0;
  /// The number of triangles left out because they are lines or points.
  vtkIdType FlatTriangles = 0;

private:
  /// A node of the grid, and where the lines from it to the next nodes along u and v cross the
  /// part's border.
  struct Node
  {
    Point Self;
    Point Crossings[2];
    bool IsThere;
    bool HasCrossing[2];
    vtkIdType Ids[3];
  };

  Node& At(int i, int j)
  {
    return this->Nodes[i + static_cast<std::size_t>(j) * (this->Columns + 1)];
  }
  void MakeNode(int i, int j);
  void MakeCrossings(int i, int j);
  void FillPoint(Point& point) const;
  void CutCell(int i, int j);
  void AddTriangle(vtkIdType a, vtkIdType b, vtkIdType c);

  const vtkTerminationSurface* Surface;
  int Part;
  int Columns;
  int Rows;
  std::vector<Node> Nodes;
};

}

#endif
