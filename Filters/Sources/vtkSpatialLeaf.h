// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkSpatialLeaf_h
#define vtkSpatialLeaf_h

#include "InterlumeSourcesModule.h" // for the export macro
#include "vtkSpatialObject.h"

/**
 * @class   vtkSpatialLeaf
 * @brief   base class of spatial objects without operands, which have a density and a color
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
   * Set/Get the factor that multiplies the density. Default 1. Valid: 0 to 1; clamped, NaN is
   * ignored.
   */
  void SetDensity(double density);
  double GetDensity() const { return this->Density; }
  ///@}

  ///@{
  /**
   * Set/Get the color as red, green, blue. Default (1, 1, 1). Valid: 0 to 1; clamped, NaN is
   * ignored.
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
