// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_RankField_h
#define interlume_RankField_h

#include "Fields/FieldPart.h"
#include "Streams/RankExchange.h"

#include "vtkSmartPointer.h"

#include <array>
#include <string>
#include <vector>

class vtkDataSet;

namespace interlume
{

/**
 * @class   RankField
 * @brief   a field on an image, a rectilinear or a structured grid, in parts that processes hold
 *
 * The cells of the whole extent are split as VTK splits extents in blocks. A process holds its own
 * cells and one layer of cells around them, as a piece with one ghost level.
 */
class RankField
{
public:
  using Extent = std::array<int, 6>;

  /// Splits an extent of points between the processes of \a controller.
  RankField(vtkMultiProcessController* controller, const int whole[6]);

  /// Returns the extent that this process has to hold; an empty one where no cell is its own.
  Extent GetHeld() const;
  /// Returns whether no cell is this process's own.
  bool IsEmpty() const;
  /// Returns the process whose own a cell is, by its index in the whole grid.
  int FindRank(const int cell[3]) const;

  /// Takes the data of this process, which are at least those of GetHeld, without the marks of what
  /// is beyond its own cells. Collective. Returns what
  /// is wrong in any process, or nothing.
  std::string SetData(vtkDataSet* data);

  vtkDataSet* GetData() const { return this->Data; }
  /// Returns the whole grid, without arrays. That of a structured grid is a rectilinear one with
  /// its bounds, and as many points.
  vtkDataSet* GetWhole() const { return this->Whole; }
  const FieldPart& GetPart() const { return this->Part; }
  RankExchange& GetExchange() { return this->Exchange; }

private:
  std::string CheckData(vtkDataSet* data) const;
  std::string MakeImage(vtkDataSet* data);
  std::string MakeRectilinearGrid(vtkDataSet* data);
  void MakeStructuredGrid(vtkDataSet* data);

  RankExchange Exchange;
  Extent WholeExtent;
  /// The extents of points of the processes' own cells.
  std::vector<Extent> Own;
  vtkSmartPointer<vtkDataSet> Data;
  vtkSmartPointer<vtkDataSet> Whole;
  FieldPart Part;
};

}

#endif
