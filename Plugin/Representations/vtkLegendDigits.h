// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkLegendDigits_h
#define vtkLegendDigits_h

#include <string>

class vtkSMPVRepresentationProxy;

/**
 * @class   vtkLegendDigits
 * @brief   digits at the ends of a display's legend
 *
 * ParaView's default format has two digits, with which both ends of a narrow range look the same.
 */
class vtkLegendDigits
{
public:
  /// Sets the format of the ends of the display's legend so that its error is at most a percent of
  /// the range of the colors. Changes only ParaView's default format and \a lastFormat, the format
  /// of the last call, which is updated.
  static void Apply(vtkSMPVRepresentationProxy* display, std::string& lastFormat);
  /// Returns the number of significant digits that the ends of a range require, 2 to 15.
  static int Find(const double range[2]);
};

#endif
