// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkSMDisplayedVolumeRepresentationProxy_h
#define vtkSMDisplayedVolumeRepresentationProxy_h

#include "InterlumeRepresentationsModule.h" // for the export macro
#include "vtkSMRepresentationProxy.h"

#include <string> // for the type

class vtkSMPVRepresentationProxy;

/**
 * @class   vtkSMDisplayedVolumeRepresentationProxy
 * @brief   proxy of a volume representation of the plugin, used as a subproxy of a display
 *
 * The attribute `type` of the XML hint Volume is the name of this representation in the display's
 * list of representations. The volume follows the translation of the display. While the volume is
 * selected, the display's panel hides the groups and properties listed in the XML hint Hidden,
 * which do not affect the volume.
 *
 * ParaView derives the default sizes of glyphs and points from the bounds of the data. While the
 * data are empty, these sizes would be negative; the proxy sets valid ones.
 */
class INTERLUMEREPRESENTATIONS_EXPORT vtkSMDisplayedVolumeRepresentationProxy
  : public vtkSMRepresentationProxy
{
public:
  static vtkSMDisplayedVolumeRepresentationProxy* New();
  vtkTypeMacro(vtkSMDisplayedVolumeRepresentationProxy, vtkSMRepresentationProxy);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkSMDisplayedVolumeRepresentationProxy();
  ~vtkSMDisplayedVolumeRepresentationProxy() override;

  void CreateVTKObjects() override;

  /// Called when the display or its data change, except for changes that this function makes.
  virtual void FollowDisplay(vtkSMPVRepresentationProxy* display);

  /// Returns the name of this representation in the display's list.
  const std::string& GetType() const { return this->Type; }

private:
  vtkSMDisplayedVolumeRepresentationProxy(const vtkSMDisplayedVolumeRepresentationProxy&) = delete;
  void operator=(const vtkSMDisplayedVolumeRepresentationProxy&) = delete;

  void DisplayChanged();
  /// Replaces invalid default sizes of the display.
  void SetValidSizes(vtkSMPVRepresentationProxy* display);

  std::string Type;
  bool HasDefaultSizes = false;
  bool IsFollowing = false;
};

#endif
