// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkIdColors_h
#define vtkIdColors_h

class vtkSMProxy;

/**
 * @class   vtkIdColors
 * @brief   assigns a color to each id 0, 1, ... of an array, and the same opacity to all
 *
 * Only ParaView's default functions, and colors that an earlier call set for another number of ids,
 * are replaced. The color map has one band per id, so the user can still edit the colors as
 * RGBPoints. Each color is annotated with its id. Automatic rescaling of the color map's range is
 * turned off.
 */
namespace vtkIdColors
{
/// Sets colors and opacities for the ids below \a count, which is clamped to the range from 2 to
/// 100. Colors repeat after ten ids.
void Apply(vtkSMProxy* colors, vtkSMProxy* opacities, int count);
}

#endif
