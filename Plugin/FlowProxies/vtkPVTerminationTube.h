// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkPVTerminationTube_h
#define vtkPVTerminationTube_h

#include "InterlumeFlowProxiesModule.h" // for the export macro
#include "vtkTerminationTube.h"

#include <array>
#include <vector>

/**
 * @class   vtkPVTerminationTube
 * @brief   a tube by what ParaView's line widget gives: where its line starts and ends
 *
 * A line of more points is taken instead where it has two and more.
 */
class INTERLUMEFLOWPROXIES_EXPORT vtkPVTerminationTube : public vtkTerminationTube
{
public:
  static vtkPVTerminationTube* New();
  vtkTypeMacro(vtkPVTerminationTube, vtkTerminationTube);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The ends of the line, in world units. Default (0, 0, -0.5), (0, 0, 0.5). Valid: finite.
   */
  void SetStart(double x, double y, double z);
  vtkGetVector3Macro(Start, double);
  void SetEnd(double x, double y, double z);
  vtkGetVector3Macro(End, double);
  ///@}

  ///@{
  /**
   * The points of a line that is not straight. Default none. Valid: finite.
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

  /// Sets the points of the base class.
  void PlacePoints();

  double Start[3] = { 0.0, 0.0, -0.5 };
  double End[3] = { 0.0, 0.0, 0.5 };
  std::vector<std::array<double, 3>> LinePoints;
};

#endif
