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
 * @brief   grid over the parameters of one part of a termination surface, clipped at the part's
 * border
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

  /// Creates points and triangles in parallel. The progress of \a owner advances from \a start to
  /// \a end. Returns false if the execution was aborted.
  bool Execute(vtkAlgorithm* owner, double start, double end);

  std::vector<Point> Points;
  std::vector<std::array<vtkIdType, 3>> Triangles;
  /// Number of points where grid edges cross the border of the part.
  vtkIdType BorderPoints = 0;
  /// Number of triangles skipped because they are degenerate.
  vtkIdType FlatTriangles = 0;

private:
  /// A grid node, and the border crossings of the grid edges to the next nodes along u and v.
  struct Node
  {
    Point Self;
    Point Crossings[2];
    bool IsInside;
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
  void ClipCell(int i, int j);
  void AddTriangle(vtkIdType a, vtkIdType b, vtkIdType c);

  const vtkTerminationSurface* Surface;
  int Part;
  int Columns;
  int Rows;
  std::vector<Node> Nodes;
};

}

#endif
