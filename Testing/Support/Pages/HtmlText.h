// SPDX-License-Identifier: BSD-3-Clause
#ifndef HtmlText_h
#define HtmlText_h

#include <string>

namespace html
{
/**
 * Escapes the special characters of HTML. The result is valid as the content of an element and as
 * an attribute value.
 */
std::string Escaped(const std::string& text);
}

#endif
