// SPDX-License-Identifier: BSD-3-Clause
#include "Pages/HtmlText.h"

namespace html
{
std::string Escaped(const std::string& text)
{
  std::string escaped;
  for (const char letter : text)
  {
    switch (letter)
    {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += letter;
    }
  }
  return escaped;
}
}
