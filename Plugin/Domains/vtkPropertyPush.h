// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkPropertyPush_h
#define vtkPropertyPush_h

class vtkSMProperty;

/**
 * @class   vtkPropertyPush
 * @brief   sends property values that a domain changed to the server
 */
class vtkPropertyPush
{
public:
  /// Returns true if the property has values that the user has not applied yet.
  static bool IsPending(vtkSMProperty* property);

  /// Sends the values of the property if its proxy already exists on the server. Call it after a
  /// domain has changed a property: a script sends only the property that it sets itself.
  static void Push(vtkSMProperty* property);
};

#endif
