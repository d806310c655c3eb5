// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkSpatialLeaf_h
#define vtkSpatialLeaf_h

#include "InterlumeSourcesModule.h" // for the export macro
#include "vtkSpatialObject.h"

/**
 * @class   vtkSpatialLeaf
 * @brief   a spatial object that is not made of others: its density inside and its colour
 *
 * @sa vtkSpatialPrimitive vtkSpatialImage
 */
class INTERLUMESOURCES_EXPORT vtkSpatialLeaf : public vtkSpatialObject
{
public:
  vtkAbstractTypeMacro(vtkSpatialLeaf, vtkSpatialObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The factor of the density. Default 1. Valid: 0 to 1; clamped, NaN changes nothing.
   */
  void SetDensity(double density);
  double GetDensity() const { return this->Density; }
  ///@}

  ///@{
  /**
   * The colour, as red, green, blue. Default 1, 1, 1. Valid: 0 to 1; clamped, NaN changes nothing.
   */
  void SetColor(double red, double green, double blue);
  vtkGetVector3Macro(Color, double);
  ///@}

protected:
  vtkSpatialLeaf() = default;
  ~vtkSpatialLeaf() override = default;

  const double* GetLeafColor() const { return this->Color; }

private:
  vtkSpatialLeaf(const vtkSpatialLeaf&) = delete;
  void operator=(const vtkSpatialLeaf&) = delete;

  double Density = 1.0;
  double Color[3] = { 1.0, 1.0, 1.0 };
};

#endif
