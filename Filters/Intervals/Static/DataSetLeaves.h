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
 * A filter that uses this class accepts composite datasets itself. Its outputs are then composite
 * datasets of the same structure.
 */
class DataSetLeaves
{
public:
  /// Declares that an input port accepts datasets of a type and composite datasets that contain
  /// them.
  static void FillInput(vtkInformation* port, const char* type);
  /// Declares that RequestDataObject() selects the data type of an output port.
  static void FillOutput(vtkInformation* port);

  /// Creates unstructured grids for a dataset, or composite datasets for a composite input. Returns
  /// 0 if there is no input.
  static int RequestDataObject(vtkInformationVector** inputs, vtkInformationVector* outputs);

  /// Returns the datasets of an input, with null for blocks that are not datasets.
  static std::vector<vtkDataSet*> Get(vtkDataObject* input);

  /// Function that extracts from a dataset and fills one grid per output port.
  using Extractor = std::function<void(vtkDataSet*, const std::vector<vtkUnstructuredGrid*>&)>;

  /// Calls \a extract for each dataset of the input. Stops if the user aborts. The progress range
  /// is divided equally among the datasets.
  static void ForEach(vtkAlgorithm* owner, vtkInformationVector** inputs,
    vtkInformationVector* outputs, const Extractor& extract);
};

/**
 * @class   OutputLeaves
 * @brief   the output grids for the datasets of an input, in the same order
 */
class OutputLeaves
{
public:
  /// \a output is a grid, or a composite dataset with the structure of the input.
  explicit OutputLeaves(vtkDataObject* output);

  /// Returns the grid for the next dataset. If \a isNeeded is false, a composite output gets no
  /// grid at that position and the result is null.
  vtkUnstructuredGrid* GetNext(bool isNeeded);

private:
  vtkUnstructuredGrid* Single;
  vtkCompositeDataSet* Composite;
  vtkSmartPointer<vtkCompositeDataIterator> At;
};

}

#endif
