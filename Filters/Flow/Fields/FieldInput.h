// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FieldInput_h
#define interlume_FieldInput_h

#include "Common/CellArrayConversion.h"

#include "vtkSmartPointer.h"

#include <vector>

class vtkDataObject;
class vtkDataSet;

namespace interlume
{

/**
 * @class   FieldInput
 * @brief   field defined by a dataset or by the blocks of a composite dataset
 *
 * The field is the dataset itself or the only block of a composite dataset. Several blocks are
 * merged by MergedDataSets. A block is a leaf with cells. Leaves without three-dimensional cells
 * are ignored if other leaves have three-dimensional cells.
 */
class FieldInput
{
public:
  struct Block
  {
    /// The data and, after SelectVectors(), the vectors.
    CellArrayConversion::Selection Selection;
    /// Flat index of the block (vtkCompositeDataIterator).
    unsigned int FlatIndex;
  };

  explicit FieldInput(vtkDataObject* input);

  /// Selects the vectors of the dataset or of each block. A dataset with a converted cell array is
  /// replaced by a copy that \a conversion holds.
  void SelectVectors(CellArrayConversion& conversion);

  /// Returns the input dataset and its vectors. The data are null if the input is composite.
  const CellArrayConversion::Selection& GetDataSet() const { return this->DataSet; }

  /// Returns the blocks, or an empty list if the input is a dataset.
  const std::vector<Block>& GetBlocks() const { return this->Blocks; }

  /// Returns whether there are blocks but none of them has three-dimensional cells.
  bool HasOnlyFlatBlocks() const;

  /// Returns whether the dataset or a block has hidden cells or points.
  bool HasHidden() const;

  /// Returns the field, or null if there is no input or the composite dataset has no blocks.
  vtkSmartPointer<vtkDataSet> MakeField() const;
  /// Returns this process's partition of a distributed field: the dataset, or a grid of the merged
  /// blocks. The grid is empty if there are no blocks or only blocks without three-dimensional
  /// cells.
  vtkSmartPointer<vtkDataSet> MakePart() const;
  /**
   * Returns the dataset with the sample points. It is \a field, or for composite input a
   * vtkUnstructuredGrid with the points and cells of \a field, because the output type must not
   * depend on the blocks.
   */
  vtkSmartPointer<vtkDataSet> MakeSamples(vtkDataSet* field) const;

  /// Returns whether the input is a composite dataset. If it is, the samples are always a
  /// vtkUnstructuredGrid.
  static bool IsComposite(vtkDataObject* input);

private:
  std::vector<vtkDataSet*> GetData() const;

  CellArrayConversion::Selection DataSet;
  std::vector<Block> Blocks;
};

}

#endif
