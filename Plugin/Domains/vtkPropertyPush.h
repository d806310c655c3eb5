// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkPropertyPush_h
#define vtkPropertyPush_h

class vtkSMProperty;

/**
 * @class   vtkPropertyPush
 * @brief sends to the server the property values that a domain changed
 */
class vtkPropertyPush
{
public:
  /// Returns true if the property has values that the user has not applied yet.
  static bool IsPending(vtkSMProperty* property);

  /// Sends the values of the property if its proxy already exists on the server. A script that sets
  /// one property sends only that one, so the domain must send the property that it changed.
  static void Push(vtkSMProperty* property);
};

#endif
