// SPDX-License-Identifier: BSD-3-Clause
#ifndef HtmlText_h
#define HtmlText_h

#include <string>

namespace html
{
/**
 * \a text with the letters that HTML takes for itself replaced, for the text of an element or the
 * value of an attribute.
 */
std::string Escaped(const std::string& text);
}

#endif
