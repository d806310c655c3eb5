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
 * @brief   returns a dataset or any piece of it, with the requested number of ghost levels
 *
 * Datasets with an extent are cropped to the requested extent. Each piece of an unstructured grid
 * has about the same number of consecutive cells, followed by ghost cells, level by level. If there
 * are several pieces, points are numbered in each piece from the last cell to the first, so that
 * tests cannot rely on their order. Global point ids are those of the complete dataset.
 *
 * If there are several time steps, Change is added to the scalars at each step after the first. The
 * active scalars must be float or double.
 */
class PieceSource : public vtkDataSetAlgorithm
{
public:
  static PieceSource* New();
  vtkTypeMacro(PieceSource, vtkDataSetAlgorithm);

  /// Sets the complete dataset, which is not copied.
  void SetFullData(vtkDataSet* complete);

  ///@{
  /// Set the number of time steps, which are at times 0, 1, ... (default 1), and the change of the
  /// scalars per step (default 1.0).
  vtkSetMacro(NumberOfTimeSteps, int);
  vtkSetMacro(Change, double);
  ///@}

  /// Set the maximum number of ghost levels, regardless of the request. 0 simulates a reader
  /// without ghost cells. Default: VTK_INT_MAX.
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

  vtkSmartPointer<vtkDataSet> FullData;
  int NumberOfTimeSteps = 1;
  double Change = 1.0;
  int MaximumGhostLevels = VTK_INT_MAX;
};

}

#endif
