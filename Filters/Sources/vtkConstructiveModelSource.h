// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkConstructiveModelSource_h
#define vtkConstructiveModelSource_h

#include "InterlumeSourcesModule.h" // for the export macro
#include "vtkConstructiveModels.h"  // for the models
#include "vtkConstructiveVolume.h"

/**
 * @class   vtkConstructiveModelSource
 * @brief   samples one of the named models of constructive volume geometry
 *
 * The root object, the bounds and the dimensions follow from the model and the resolution when
 * either is set, the margin being a twentieth of the longest side.
 *
 * @sa vtkConstructiveModels
 */
class INTERLUMESOURCES_EXPORT vtkConstructiveModelSource : public vtkConstructiveVolume
{
public:
  static vtkConstructiveModelSource* New();
  vtkTypeMacro(vtkConstructiveModelSource, vtkConstructiveVolume);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The model that is sampled. Default ROBOT. Valid: see vtkConstructiveModels::Models; clamped.
   */
  void SetModel(int model);
  vtkGetMacro(Model, int);
  ///@}

  ///@{
  /**
   * The number of points of the longest side. Default 128. Valid: 2 to 2048; clamped.
   */
  void SetResolution(int resolution);
  vtkGetMacro(Resolution, int);
  ///@}

protected:
  vtkConstructiveModelSource();
  ~vtkConstructiveModelSource() override = default;

private:
  vtkConstructiveModelSource(const vtkConstructiveModelSource&) = delete;
  void operator=(const vtkConstructiveModelSource&) = delete;

  int Model = vtkConstructiveModels::ROBOT;
  int Resolution = 128;
};

#endif
