// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporaryFolder_h
#define TemporaryFolder_h

#include <filesystem>
#include <random>
#include <string>
#include <system_error>

/**
 * A temporary directory, removed by the destructor.
 */
class TemporaryFolder
{
public:
  explicit TemporaryFolder(const std::string& name)
    : Path(std::filesystem::temp_directory_path() /
        (name + "-" + std::to_string(std::random_device()())))
  {
    this->Clear();
  }
  ~TemporaryFolder()
  {
    std::error_code ignored;
    std::filesystem::remove_all(this->Path, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  /// Removes all files.
  void Clear() const
  {
    std::filesystem::remove_all(this->Path);
    std::filesystem::create_directories(this->Path);
  }

  const std::filesystem::path Path;
};

#endif
