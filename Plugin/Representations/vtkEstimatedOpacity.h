// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkEstimatedOpacity_h
#define vtkEstimatedOpacity_h

class vtkSMPVRepresentationProxy;
class vtkSMProxy;

/**
 * @class   vtkEstimatedOpacity
 * @brief   replaces ParaView's default opacity function with one estimated from the data
 *
 * ParaView's default is a ramp from 0 to 1 over the range of the data, so that background and noise
 * hide everything else. See OpacityEstimate for the method.
 */
namespace vtkEstimatedOpacity
{
/// Returns true if the opacities are ParaView's default ramp.
bool IsDefault(vtkSMProxy* opacities);
/// Replaces the opacities with an estimate for the display's color array if they are ParaView's
/// default. Returns false if the range of the array is not known yet.
bool Apply(vtkSMProxy* opacities, vtkSMPVRepresentationProxy* display);
}

#endif
