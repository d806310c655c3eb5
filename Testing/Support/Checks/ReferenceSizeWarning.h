// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceSizeWarning_h
#define ReferenceSizeWarning_h

#include <regex>  // for the warnings
#include <string> // for the warnings
#include <vector> // for the sizes

namespace reference
{

/// The numbers in a warning about a large output. Numbers from 100,000 are rounded in the text.
struct ReportedSize
{
  double Tetrahedra = 0.0;
  double Bytes = 0.0;
};

/// Returns the numbers of all warnings about a large output in a text.
inline std::vector<ReportedSize> FindSizes(const std::string& text)
{
  static const std::regex pattern(
    "The output will have (?:about |at least )?([0-9.]+)( million| billion)? tetrahedra"
    "[^.]* take about ([0-9.]+) (MB|GB)");
  std::vector<ReportedSize> sizes;
  for (auto at = std::sregex_iterator(text.begin(), text.end(), pattern);
       at != std::sregex_iterator(); ++at)
  {
    const std::string unit = (*at)[2];
    sizes.push_back({ std::stod((*at)[1]) *
        (unit == " million"      ? 1e6
            : unit == " billion" ? 1e9
                                 : 1.0),
      std::stod((*at)[3]) * ((*at)[4] == "MB" ? 1e6 : 1e9) });
  }
  return sizes;
}

}

#endif
