// SPDX-License-Identifier: BSD-3-Clause
// An entry for libFuzzer: the first byte chooses the file, the others are its bytes, at first those
// that an earlier run has left. A finding is a run that does not give what it gives without the
// file.
#include "FuzzFiles.h"

#include "vtkLogger.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <iostream>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

extern "C" std::size_t LLVMFuzzerCustomMutator(
  std::uint8_t* data, std::size_t size, std::size_t most, unsigned int seed)
{
  if (size > 2)
  {
    return LLVMFuzzerMutate(data, size, most);
  }
  const auto& kinds = fuzz::GetFileKinds();
  const std::size_t kind = seed % kinds.size();
  const std::string bytes = static_cast<char>(kind) + kinds[kind].MakeBytes();
  const std::size_t taken = std::min(bytes.size(), most);
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
  const std::string fault =
    kind.Try(std::string(reinterpret_cast<const char*>(data + 1), size - 1));
  if (!fault.empty())
  {
    std::cerr << kind.Name << ": " << fault << std::endl;
    std::abort();
  }
  return 0;
}
