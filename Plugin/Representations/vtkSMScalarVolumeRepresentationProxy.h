// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkSMScalarVolumeRepresentationProxy_h
#define vtkSMScalarVolumeRepresentationProxy_h

#include "InterlumeRepresentationsModule.h" // for the export macro
#include "vtkSMDisplayedVolumeRepresentationProxy.h"

#include <set>    // for a member
#include <string> // for the array

/**
 * @class   vtkSMScalarVolumeRepresentationProxy
 * @brief   selects a color array when a volume of the plugin is shown
 *
 * The proxy acts when the display switches to the volume, in the GUI, in Python and in pvbatch:
 *
 * - If the display has no color array, the proxy selects one. It prefers arrays that are not ids,
 *   then arrays whose range is not a single value, then point arrays, then arrays with one
 *   component. The proxy does not select an array after the user has selected Solid Color for the
 *   volume, while a state file is loaded, or during undo and redo. If the data have no array, the
 *   proxy tries again after the next change.
 * - While the display is colored by the scalars that the source's filter uses, it follows them when
 *   others are selected. The XML hint ColorBy of the filter has the name of the property.
 * - The legend shows as many digits at its ends as the range of the colors requires, unless its
 *   format was changed.
 * - If the array is listed in the XML hint Categories (ids 0, 1, ...), each id gets its own color,
 *   and all ids get the same opacity. Modified color and opacity functions remain unchanged.
 * - If there is an XML hint EstimatedOpacity and the array is not listed in Categories, the opacity
 *   function is estimated from the data once (see OpacityEstimate). This applies only to ParaView's
 *   default function, a ramp from 0 to 1. Functions from a state file remain unchanged.
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

  /// Colors the display by its array; if it has none, selects one first. Returns true on success.
  bool ColorDisplay(vtkSMPVRepresentationProxy* display);
  /// Colors the display by the scalars of the filter if it was colored by the previous ones.
  void FollowScalars(vtkSMPVRepresentationProxy* display, bool isRestoring);
  /// Sets separate colors for ids if the array is in the hint Categories.
  void ColorCategories(vtkSMPVRepresentationProxy* display);
  /// Estimates each opacity function from the data, but only once. Restored functions are not
  /// changed.
  void EstimateOpacity(vtkSMPVRepresentationProxy* display, bool isRestoring);

  bool IsShown = false;
  bool NeedsArray = false;
  bool IsSolidByChoice = false;
  std::string Scalars;      ///< the scalars of the filter at the last call of FollowScalars
  std::string LegendFormat; ///< the last format that vtkLegendDigits has set
  /// Array, color map and number of ids of the last call of vtkIdColors::Apply.
  std::string PreparedArray;
  vtkSMProxy* PreparedColors = nullptr;
  int PreparedIds = 0;
  /// Global ids of the opacity function proxies that EstimateOpacity has set or left unchanged.
  std::set<vtkTypeUInt32> PreparedOpacities;
};

#endif
