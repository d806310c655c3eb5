// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkSelectionIds_h
#define vtkSelectionIds_h

#include "vtkNew.h"
#include "vtkType.h"

class vtkDataObject;
class vtkDataSet;
class vtkUnstructuredGrid;
class vtkVolumeRepresentationPreprocessor;

/**
 * @class   vtkSelectionIds
 * @brief   find the input's ids of the tetrahedra that a representation draws, for selection
 *
 * ParaView merges blocks and splits cells into tetrahedra before it draws them. This class does the
 * same with the input's ids as arrays, when something is selected for the first time.
 */
class vtkSelectionIds
{
public:
  vtkSelectionIds();
  ~vtkSelectionIds();

  /// Returns the preprocessor, which must have the settings of that of the representation.
  vtkVolumeRepresentationPreprocessor* GetPreprocessor() { return this->Preprocessor; }

  /**
   * Returns the ids (see vtkTimeWeightedTetrahedraMapper::SetSelectionIds) of the tetrahedra that
   * were created from \a input. Returns null if \a tetrahedra are the cells of the input.
   */
  vtkDataSet* Update(vtkDataObject* input, vtkUnstructuredGrid* tetrahedra);

private:
  vtkNew<vtkVolumeRepresentationPreprocessor> Preprocessor;
  vtkDataObject* Input = nullptr;
  /// Modification times of the input and of the preprocessor at the last update.
  vtkMTimeType InputTime = 0;
  vtkMTimeType SettingsTime = 0;
};

#endif
