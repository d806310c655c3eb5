// SPDX-License-Identifier: BSD-3-Clause
#ifndef HtmlText_h
#define HtmlText_h

#include <string>

namespace html
{
/**
 * Replaces the characters that are special in HTML. The result is valid in an element or an
 * attribute value.
 */
std::string Escaped(const std::string& text);
}

#endif
