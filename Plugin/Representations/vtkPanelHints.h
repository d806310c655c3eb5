// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkPanelHints_h
#define vtkPanelHints_h

class vtkPVXMLElement;
class vtkSMProxy;

/**
 * @class   vtkPanelHints
 * @brief   hides parts of a display's panel for one of its representations
 */
namespace vtkPanelHints
{
/**
 * Hides for the type \a type of \a display what \a hidden names in nested elements: `Property` by
 * `name`; `Group` by `label`, without the properties that its `except` names. For other types, and
 * in other displays, all stays as it is.
 */
void Hide(vtkSMProxy* display, const char* type, vtkPVXMLElement* hidden);
}

#endif
