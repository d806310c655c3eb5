// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_DataSetLeaves_h
#define interlume_DataSetLeaves_h

#include "vtkSmartPointer.h"

#include <functional>
#include <vector>

class vtkAlgorithm;
class vtkCompositeDataIterator;
class vtkCompositeDataSet;
class vtkDataObject;
class vtkDataSet;
class vtkInformation;
class vtkInformationVector;
class vtkUnstructuredGrid;

namespace interlume
{

/**
 * @class   DataSetLeaves
 * @brief   the datasets of an input that may be composite
 *
 * A filter that uses it accepts composite datasets itself, and its outputs are then composite
 * datasets of the same structure.
 */
class DataSetLeaves
{
public:
  /// Accepts datasets of a type, and composite datasets of them, at an input port.
  static void FillInput(vtkInformation* port, const char* type);
  /// Lets RequestDataObject choose the type of an output port.
  static void FillOutput(vtkInformation* port);

  /// Creates outputs that are unstructured grids or composite datasets, as the input is. Returns 0
  /// if there is no input.
  static int RequestDataObject(vtkInformationVector** inputs, vtkInformationVector* outputs);

  /// Returns the datasets of an input, with null for blocks that are not datasets.
  static std::vector<vtkDataSet*> Get(vtkDataObject* input);

  /// Extracts from a dataset into a grid for each output port.
  using Extractor = std::function<void(vtkDataSet*, const std::vector<vtkUnstructuredGrid*>&)>;

  /// Calls \a extract for each dataset of the input until the user aborts. Each dataset has the
  /// same share of the progress.
  static void ForEach(vtkAlgorithm* owner, vtkInformationVector** inputs,
    vtkInformationVector* outputs, const Extractor& extract);
};

/**
 * @class   OutputLeaves
 * @brief   the grids of an output for the datasets of its input, in their order
 */
class OutputLeaves
{
public:
  /// \a output is a grid, or a composite dataset with the structure of the input.
  explicit OutputLeaves(vtkDataObject* output);

  /// Returns the grid of the next dataset. If \a isNeeded is false, a composite output gets no grid
  /// there, and the result is null.
  vtkUnstructuredGrid* GetNext(bool isNeeded);

private:
  vtkUnstructuredGrid* Single;
  vtkCompositeDataSet* Composite;
  vtkSmartPointer<vtkCompositeDataIterator> At;
};

}

#endif
