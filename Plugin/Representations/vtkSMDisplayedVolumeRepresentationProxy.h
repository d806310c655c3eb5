// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkSMDisplayedVolumeRepresentationProxy_h
#define vtkSMDisplayedVolumeRepresentationProxy_h

#include "InterlumeRepresentationsModule.h" // for the export macro
#include "vtkSMRepresentationProxy.h"

#include <string> // for the type

class vtkSMPVRepresentationProxy;

/**
 * @class   vtkSMDisplayedVolumeRepresentationProxy
 * @brief   a volume of the plugin as one of the representations of a display
 *
 * A subproxy of a display, and the representation that the display calls by the `type` of this
 * proxy's hint Volume. It is moved with the display, and the parts of the display's panel that
 * change no picture of it are hidden: the groups and properties that the hint Hidden names.
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

  /// Called when the display has changed, and when its data have; not by what it changes itself.
  virtual void FollowDisplay(vtkSMPVRepresentationProxy* display);

  /// The name by which the display calls this representation.
  const std::string& GetType() const { return this->Type; }

private:
  vtkSMDisplayedVolumeRepresentationProxy(const vtkSMDisplayedVolumeRepresentationProxy&) = delete;
  void operator=(const vtkSMDisplayedVolumeRepresentationProxy&) = delete;

  void DisplayChanged();

  std::string Type;
  bool IsFollowing = false;
};

#endif
