// SPDX-License-Identifier: BSD-3-Clause
// libFuzzer entry point. The first byte selects the kind of file, and the remaining bytes are the
// content of the file. The seed of each kind is an intact file. An error message from FileKind::Try
// aborts the program, which libFuzzer reports.
#include "FuzzFiles.h"

#include "vtkLogger.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <iostream>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t capacity);

extern "C" std::size_t LLVMFuzzerCustomMutator(
  std::uint8_t* data, std::size_t size, std::size_t capacity, unsigned int seed)
{
  if (size > 2)
  {
    return LLVMFuzzerMutate(data, size, capacity);
  }
  const auto& kinds = fuzz::GetFileKinds();
  const std::size_t kind = seed % kinds.size();
  const std::string bytes = static_cast<char>(kind) + kinds[kind].MakeBytes();
  const std::size_t taken = std::min(bytes.size(), capacity);
  std::copy_n(bytes.begin(), taken, data);
  return taken;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  if (size == 0)
  {
    return 0;
  }
  const auto& kinds = fuzz::GetFileKinds();
  const fuzz::FileKind& kind = kinds[data[0] % kinds.size()];
  const std::string error =
    kind.Try(std::string(reinterpret_cast<const char*>(data + 1), size - 1));
  if (!error.empty())
  {
    std::cerr << kind.Name << ": " << error << std::endl;
    std::abort();
  }
  return 0;
}
