// SPDX-License-Identifier: BSD-3-Clause
#ifndef FuzzFiles_h
#define FuzzFiles_h

#include <string> // for the bytes
#include <vector> // for the list

/**
 * Files that a filter writes and that a later run of the filter reads. Regardless of the content of
 * such a file, the later run must produce the same result as without the file.
 */
namespace fuzz
{

struct FileKind
{
  std::string Name;
  /// Returns the intact file, as written by an earlier run.
  std::string (*MakeBytes)();
  /// Writes \a bytes to the file and runs again. Returns an error message, or an empty string on
  /// success.
  std::string (*Try)(const std::string& bytes);
};

/// Returns two kinds of files: checkpoints of vtkImplicitFlowField and slabs of vtkTimeSlabWriter.
const std::vector<FileKind>& GetFileKinds();

}

#endif
