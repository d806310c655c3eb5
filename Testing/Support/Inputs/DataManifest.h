// SPDX-License-Identifier: BSD-3-Clause
#ifndef DataManifest_h
#define DataManifest_h

#include <string>
#include <vector>

namespace interlume
{
/**
 * A row of Data/MANIFEST.md: the content, source and license of a file.
 */
struct DataRow
{
  std::string File;
  std::string Content;
  std::string Source;
  std::string License;
};

/**
 * Returns the rows of Data/MANIFEST.md, that is, the lines of its table whose first column is a
 * file name in backquotes.
 * @throw std::runtime_error if the manifest cannot be read or has no rows.
 */
std::vector<DataRow> ReadDataManifest();

/**
 * Returns the row of \a file.
 * @throw std::runtime_error if it does not exist: every file requires a source and a license.
 */
const DataRow& FindDataRow(const std::vector<DataRow>& rows, const std::string& file);
}

#endif
