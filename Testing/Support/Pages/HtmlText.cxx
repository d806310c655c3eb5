// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Pages/HtmlText.h"

#include <map>

namespace html
{
std::string Escaped(const std::string& text)
{
  static const std::map<char, const char*> entities = { { '&', "&amp;" }, { '<', "&lt;" },
    { '>', "&gt;" }, { '"', "&quot;" } };
  std::string escaped;
  for (const char letter : text)
  {
    const auto found = entities.find(letter);
    escaped += found == entities.end() ? std::string(1, letter) : found->second;
  }
  return escaped;
}
}
