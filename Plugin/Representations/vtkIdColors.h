// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkIdColors_h
#define vtkIdColors_h

class vtkSMProxy;

/**
 * @class   vtkIdColors
 * @brief   gives the ids 0, 1, .. of an array a colour each, and all the same opacity
 *
 * Only functions that are as ParaView made them are changed, and colours that were set here, for
 * more ids. The colours of a table are bands around the ids, so that setting its RGBPoints works as
 * ever; the ids are its annotations. Its range is no longer rescaled by itself.
 */
namespace vtkIdColors
{
/// Colours the \a count first ids; at most as many as have colours of their own are told apart.
void Apply(vtkSMProxy* colors, vtkSMProxy* opacities, int count);
}

#endif
