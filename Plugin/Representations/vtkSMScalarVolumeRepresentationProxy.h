// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkSMScalarVolumeRepresentationProxy_h
#define vtkSMScalarVolumeRepresentationProxy_h

#include "InterlumeRepresentationsModule.h" // for the export macro
#include "vtkSMDisplayedVolumeRepresentationProxy.h"

#include <string> // for the array

/**
 * @class   vtkSMScalarVolumeRepresentationProxy
 * @brief   colours a display when a volume of the plugin is switched on in it, as ParaView's Volume
 *
 * Whenever that is what the display shows:
 *
 * - Without an array to colour by it takes one, as ParaView does for its own Volume: from the GUI,
 *   from Python by method or property, in pvbatch. It prefers an array that is no ids, then one
 *   with a range, of points, of one component. Solid Color that was chosen while the volume is
 *   shown is kept, and so is what a state file or undo sets. Where the data have no array, the next
 *   change looks again.
 * - By an array that the hint Categories names, with ids 0, 1, ..: each id has a colour of its own,
 *   all the same opacity, if colours and opacities were the first ones of ParaView.
 */
class INTERLUMEREPRESENTATIONS_EXPORT vtkSMScalarVolumeRepresentationProxy
  : public vtkSMDisplayedVolumeRepresentationProxy
{
public:
  static vtkSMScalarVolumeRepresentationProxy* New();
  vtkTypeMacro(vtkSMScalarVolumeRepresentationProxy, vtkSMDisplayedVolumeRepresentationProxy);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkSMScalarVolumeRepresentationProxy();
  ~vtkSMScalarVolumeRepresentationProxy() override;

  void FollowDisplay(vtkSMPVRepresentationProxy* display) override;

private:
  vtkSMScalarVolumeRepresentationProxy(const vtkSMScalarVolumeRepresentationProxy&) = delete;
  void operator=(const vtkSMScalarVolumeRepresentationProxy&) = delete;

  /// Colours the display by an array where that is due. Returns whether the display colours by an
  /// array then.
  bool ColorDisplay(vtkSMPVRepresentationProxy* display);
  void ColorCategories(vtkSMPVRepresentationProxy* display);

  bool IsShown = false;
  bool NeedsArray = false;
  bool IsSolidByChoice = false;
  /// The array, its functions and how many ids they were prepared for.
  std::string PreparedArray;
  vtkSMProxy* PreparedColors = nullptr;
  int PreparedIds = 0;
};

#endif
