// SPDX-License-Identifier: BSD-3-Clause
#ifndef IndexPage_h
#define IndexPage_h

#include "Gallery/SceneReport.h"

#include <string>
#include <vector>

namespace gallery
{
/**
 * Writes \a folder/index.html: one self-contained page that shows the pictures `<id>.png` beside it
 * with title, figure, caption, times, counters, data and licence.
 * @throw std::runtime_error when it can't be written.
 */
void WriteIndexPage(const std::string& folder, const std::vector<SceneReport>& reports);
}

#endif
