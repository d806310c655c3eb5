// SPDX-License-Identifier: BSD-3-Clause
#ifndef FuzzFiles_h
#define FuzzFiles_h

#include <string> // for the bytes
#include <vector> // for the list

/**
 * Files of ours that a later run reads: whatever bytes are in the place of one, that run gives what
 * it gives without.
 */
namespace fuzz
{

struct FileKind
{
  std::string Name;
  /// What an earlier run has left.
  std::string (*MakeBytes)();
  /// Puts \a bytes in the place of that file and runs again. Returns what is wrong with that, or
  /// nothing.
  std::string (*Try)(const std::string& bytes);
};

/// The checkpoint of vtkImplicitFlowField, and a slab of vtkTimeSlabWriter.
const std::vector<FileKind>& GetFileKinds();

}

#endif
