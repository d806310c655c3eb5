// SPDX-License-Identifier: BSD-3-Clause
#ifndef IndexPage_h
#define IndexPage_h

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace gallery
{
/**
 * Writes \a folder/index.html, a page that shows the images `<id>.png` in the same directory, each
 * with its title, figure number, caption, times, counters, data sources and license. \a reports are
 * results of ToJson().
 * @throw std::runtime_error if the file cannot be written.
 */
void WriteIndexPage(const std::string& folder, const std::vector<nlohmann::json>& reports);
}

#endif
