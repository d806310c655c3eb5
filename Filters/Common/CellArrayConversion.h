// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_CellArrayConversion_h
#define interlume_CellArrayConversion_h

#include "InterlumeCommonModule.h" // for the export macro
#include "vtkDataObject.h"         // for the associations
#include "vtkSmartPointer.h"

#include <map>
#include <string>
#include <vector>

class vtkAbstractArray;
class vtkAlgorithm;
class vtkDataArray;
class vtkDataSet;
class vtkDataSetAttributes;
class vtkInformation;
class vtkInformationVector;

namespace interlume
{

/**
 * @class   CellArrayConversion
 * @brief   selects the array that a filter processes, and converts cell arrays to point arrays
 *
 * vtkCellDataToPointData averages the cells at each point. The filter then processes a shallow copy
 * of the dataset with the averages as an additional point array, which replaces a point array of
 * the same name. All other data remain unchanged. If the dataset has no array of the requested
 * association, an array with the same name or attribute type of the other association is selected.
 *
 * Results are cached until the dataset changes.
 */
class INTERLUMECOMMON_EXPORT CellArrayConversion
{
public:
  struct Selection
  {
    /// The dataset, or a copy with the converted arrays.
    vtkDataSet* Data;
    /// The array to process. It is a point array unless it is missing or invalid.
    vtkAbstractArray* Array = nullptr;
    int Association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  };

  struct Converted
  {
    vtkMTimeType InputTime = 0;
    std::vector<vtkDataArray*> Sources;
    vtkSmartPointer<vtkDataSet> Data;
    std::vector<vtkDataArray*> Arrays;
    bool IsUsed = false;
  };
  using Cache = std::map<vtkDataSet*, Converted>;

  /// The array to process must have \a components components. \a names are further one-component
  /// arrays. \a cache, if not null, keeps the results longer than this object.
  CellArrayConversion(vtkAlgorithm* owner, int components,
    const std::vector<std::string>& names = {}, Cache* cache = nullptr);
  ~CellArrayConversion();

  /// Returns the array to process in a dataset. The result is valid until Clear() or until the
  /// dataset changes.
  Selection Select(vtkDataSet* input);

  /// Releases all results except those in a cache of the caller.
  void Clear() { this->OwnResults.clear(); }

  /// Returns the names of all cell arrays converted so far.
  const std::vector<std::string>& GetNames() const { return this->ConvertedNames; }

  /// Returns the array to process and its association, without converting it.
  static vtkAbstractArray* FindRequested(vtkAlgorithm* owner, vtkDataSet* input, int& association);

  /// Returns the point array with the given name or, if there is none, the cell array.
  static Selection FindByName(vtkDataSet* data, const std::string& name);

  /// Returns the requested array in one set of attributes, or null.
  static vtkAbstractArray* Find(vtkInformation* request, vtkDataSetAttributes* attributes);

  /// Requests another layer of ghost cells if one of several pieces is requested and a cell array
  /// may be selected. Otherwise, points at the boundary of the piece would lack cells.
  static void RequestGhostCells(
    vtkAlgorithm* owner, vtkInformationVector** inputs, vtkInformationVector* outputs);

  static int GetAssociation(vtkInformation* request);

private:
  const Converted& Convert(vtkDataSet* input, const std::vector<vtkDataArray*>& sources);
  void Activate(const Converted& converted) const;
  vtkSmartPointer<vtkDataArray> Average(vtkDataSet* input, vtkDataArray* source);

  vtkAlgorithm* Owner;
  int Components;
  std::vector<std::string> Names;
  std::vector<std::string> ConvertedNames;
  Cache OwnResults;
  Cache* External;
};

}

#endif
