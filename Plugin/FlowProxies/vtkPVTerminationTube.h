// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkPVTerminationTube_h
#define vtkPVTerminationTube_h

#include "InterlumeFlowProxiesModule.h" // for the export macro
#include "vtkTerminationTube.h"

#include <array>
#include <vector>

/**
 * @class   vtkPVTerminationTube
 * @brief   termination tube with the parameters of ParaView's line widget
 *
 * The tube surrounds the line from Start to End. If there are two or more line points, it surrounds
 * the polyline through them instead.
 */
class INTERLUMEFLOWPROXIES_EXPORT vtkPVTerminationTube : public vtkTerminationTube
{
public:
  static vtkPVTerminationTube* New();
  vtkTypeMacro(vtkPVTerminationTube, vtkTerminationTube);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the ends of the line, in world units. Default: (0, 0, -0.5), (0, 0, 0.5). Valid:
   * finite.
   */
  void SetStart(double x, double y, double z);
  vtkGetVector3Macro(Start, double);
  void SetEnd(double x, double y, double z);
  vtkGetVector3Macro(End, double);
  ///@}

  ///@{
  /**
   * Add or remove the points of a polyline, in world units. Default: none. Valid: finite.
   */
  void AddLinePoint(double x, double y, double z);
  void RemoveAllLinePoints();
  ///@}

protected:
  vtkPVTerminationTube();
  ~vtkPVTerminationTube() override = default;

private:
  vtkPVTerminationTube(const vtkPVTerminationTube&) = delete;
  void operator=(const vtkPVTerminationTube&) = delete;

  /// Sets the points of the superclass.
  void PlacePoints();

  double Start[3] = { 0.0, 0.0, -0.5 };
  double End[3] = { 0.0, 0.0, 0.5 };
  std::vector<std::array<double, 3>> LinePoints;
};

#endif
