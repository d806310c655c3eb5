// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferencePieceSource_h
#define ReferencePieceSource_h

#include "vtkDataSetAlgorithm.h"
#include "vtkSmartPointer.h" // for the dataset

class vtkDataSet;
class vtkUnstructuredGrid;

namespace reference
{

/**
 * @class   PieceSource
 * @brief   gives a dataset whole or any piece of it, with as many ghost levels as are asked for
 *
 * Grids with rows are cut by the extent that the pipeline asks for. Of an unstructured grid a piece
 * has an equal share of the cells, in their order; ghost cells follow, level by level. Its points
 * have numbers of their own, from the last cell to the first, and the whole's as global ids, so
 * that nothing can rely on the order in which a piece stores its points.
 *
 * With more than one time step the scalars have Change added at each step from the second on; the
 * scalars must be the dataset's active ones, of float or double.
 */
class PieceSource : public vtkDataSetAlgorithm
{
public:
  static PieceSource* New();
  vtkTypeMacro(PieceSource, vtkDataSetAlgorithm);

  /// The dataset; kept.
  void SetWhole(vtkDataSet* whole);

  ///@{
  /// The time steps 0, 1, ... and what scalars grow by from one to the next. Default 1 and 1.0.
  vtkSetMacro(NumberOfTimeSteps, int);
  vtkSetMacro(Change, double);
  ///@}

  /// The most ghost levels given, whatever is asked for: 0 stands for a reader that has none.
  /// Default VTK_INT_MAX.
  vtkSetMacro(MaximumGhostLevels, int);

protected:
  PieceSource();
  ~PieceSource() override;

  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  PieceSource(const PieceSource&) = delete;
  void operator=(const PieceSource&) = delete;

  void FillPiece(int piece, int pieces, int levels, vtkUnstructuredGrid* part) const;

  vtkSmartPointer<vtkDataSet> Whole;
  int NumberOfTimeSteps = 1;
  double Change = 1.0;
  int MaximumGhostLevels = VTK_INT_MAX;
};

}

#endif
