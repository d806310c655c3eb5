// SPDX-License-Identifier: BSD-3-Clause
#ifndef FlowDisc_h
#define FlowDisc_h

#include "vtkFlowVolume.h"
#include "vtkImplicitFlowField.h"
#include "vtkInflowMapping.h"

#include "vtkNew.h"

#include <functional>

/**
 * Stream volumes that begin at a disc.
 */
namespace flow
{
/**
 * A disc across x.
 */
struct Disc
{
  double X = 0.0;
  double Y = 0.0;
  double Z = 0.0;
  double Radius = 1.0;

  /// The integral of a function over the disc.
  double Integrate(const std::function<double(const double x[3])>& function) const;
};

/**
 * The stream volume of a disc by implicit flow: followed back to a plane that reaches as far as
 * any streamline, the inflow is the distance from the disc's centre.
 */
struct DiscVolume
{
  /// The field is to be given yet.
  explicit DiscVolume(const Disc& disc);

  vtkNew<vtkImplicitFlowField> Field;
  vtkNew<vtkInflowMapping> Mapping;
  vtkNew<vtkFlowVolume> Volume;
};
}

#endif
