// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FieldInput_h
#define interlume_FieldInput_h

#include "vtkSmartPointer.h"

#include <vector>

class vtkDataObject;
class vtkDataSet;

namespace interlume
{

/**
 * @class   FieldInput
 * @brief   the field that a dataset, or a composite dataset, is
 *
 * A dataset is the field itself, and so is the only block of a composite one; several blocks are
 * one grid by MergedDataSets. A block is a leaf with cells; leaves without cells of three
 * dimensions are none where others have some.
 */
class FieldInput
{
public:
  struct Block
  {
    vtkDataSet* Data;
    /// The index of the block as vtkCompositeDataIterator counts.
    unsigned int FlatIndex;
  };

  explicit FieldInput(vtkDataObject* input);

  /// Returns the blocks; empty for a dataset, which has none.
  const std::vector<Block>& GetBlocks() const { return this->Blocks; }

  /// Returns whether there are blocks, and all of them are flat.
  bool HasFlatBlocks() const;

  /// Returns whether cells or points are hidden, of the dataset or a block.
  bool HasHidden() const;

  /// Makes the field, merging blocks; null without an input, or without a block.
  vtkSmartPointer<vtkDataSet> MakeField() const;
  /// Makes this process's part of the field, where others have other blocks: one grid of its
  /// blocks, without cells where they are none or flat. A dataset is the part itself.
  vtkSmartPointer<vtkDataSet> MakePart() const;
  /**
   * Makes the dataset whose points are the samples: \a field, or for composite input, whose type is
   * not known before it is there, a vtkUnstructuredGrid of its points and cells.
   */
  vtkSmartPointer<vtkDataSet> MakeSamples(vtkDataSet* field) const;

  /// Returns whether samples will be a vtkUnstructuredGrid, whatever the blocks are.
  static bool IsComposite(vtkDataObject* input);

private:
  /// Returns the blocks' data.
  std::vector<vtkDataSet*> GetData() const;

  vtkDataSet* Whole;
  std::vector<Block> Blocks;
};

}

#endif
