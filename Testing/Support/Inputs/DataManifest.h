// SPDX-License-Identifier: BSD-3-Clause
#ifndef DataManifest_h
#define DataManifest_h

#include <string>
#include <vector>

namespace interlume
{
/**
 * One row of Data/MANIFEST.md: where a file comes from and on which terms.
 */
struct DataRow
{
  std::string File;
  std::string Content;
  std::string Source;
  std::string Licence;
};

/**
 * The rows of Data/MANIFEST.md: the lines of its table whose first column is a file in backquotes.
 * @throw std::runtime_error when the manifest can't be read or has no row.
 */
std::vector<DataRow> ReadDataManifest();

/**
 * The row of \a file.
 * @throw std::runtime_error when there is none: no file is used without its source and licence.
 */
const DataRow& FindDataRow(const std::vector<DataRow>& rows, const std::string& file);
}

#endif
