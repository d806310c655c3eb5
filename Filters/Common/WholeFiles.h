// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_WholeFiles_h
#define interlume_WholeFiles_h

#include "Common/DataDigest.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkNew.h"
#include "vtkXMLReader.h"
#include "vtkXMLWriter.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>
#include <vector>

namespace interlume
{

/**
 * Files of VTK's XML formats that are whole or not there: they are written beside themselves and
 * then renamed, so that a process that is killed in writing leaves the file before. A comment at
 * the end has a digest of all before it, so that damage is seen before a reader stumbles over it.
 * Names are in UTF-8, as VTK has them.
 */
namespace WholeFiles
{
inline std::filesystem::path GetPath(const std::string& fileName)
{
  return std::filesystem::u8path(fileName);
}

inline std::string GetTemporaryName(const std::string& fileName)
{
  return fileName + ".part";
}

inline bool IsThere(const std::string& fileName)
{
  std::error_code ignored;
  return std::filesystem::exists(GetPath(fileName), ignored);
}

inline void Remove(const std::string& fileName)
{
  // It is no error if there is none.
  std::error_code ignored;
  std::filesystem::remove(GetPath(fileName), ignored);
}

/// Puts what was written to the temporary name in the place of the file, or removes it. Returns
/// whether the file is there.
inline bool Finish(const std::string& fileName, bool isWritten)
{
  const std::string temporary = GetTemporaryName(fileName);
  std::error_code error;
  if (isWritten)
  {
    std::filesystem::rename(GetPath(temporary), GetPath(fileName), error);
  }
  if (!isWritten || error)
  {
    Remove(temporary);
  }
  return isWritten && !error;
}

/// Returns whether the temporary file can be made, and removes it, whoever has left it.
inline bool CanWrite(const std::string& fileName)
{
  const bool can = static_cast<bool>(std::ofstream(GetPath(GetTemporaryName(fileName))));
  Remove(GetTemporaryName(fileName));
  return can;
}

/// Returns the comment that ends a file of whose bytes it has the digest, or nothing where the file
/// is shorter.
inline std::string GetLastLine(const std::string& fileName, std::uintmax_t bytes)
{
  std::ifstream file(GetPath(fileName), std::ios::in | std::ios::binary);
  DataDigest digest;
  std::vector<char> part(std::size_t(1) << 20);
  while (bytes > 0)
  {
    const auto number = std::min<std::uintmax_t>(bytes, part.size());
    if (!file.read(part.data(), static_cast<std::streamsize>(number)))
    {
      return std::string();
    }
    digest.Add(part.data(), static_cast<std::size_t>(number));
    bytes -= number;
  }
  return "<!-- MD5 " + digest.Take() + " -->\n";
}

/// Ends a file with the digest of its bytes. Returns whether that was possible.
inline bool Seal(const std::string& fileName)
{
  std::error_code error;
  const std::uintmax_t bytes = std::filesystem::file_size(GetPath(fileName), error);
  const std::string line = error ? std::string() : GetLastLine(fileName, bytes);
  std::ofstream file(GetPath(fileName), std::ios::out | std::ios::binary | std::ios::app);
  file << line << std::flush;
  return !line.empty() && file;
}

/// Returns whether a file is as it was sealed.
inline bool IsSealed(const std::string& fileName)
{
  std::string line = GetLastLine(fileName, 0);
  std::error_code error;
  const std::uintmax_t bytes = std::filesystem::file_size(GetPath(fileName), error);
  if (error || bytes < line.size())
  {
    return false;
  }
  const std::uintmax_t before = bytes - line.size();
  std::ifstream file(GetPath(fileName), std::ios::in | std::ios::binary);
  file.seekg(static_cast<std::streamoff>(before));
  return file.read(&line[0], static_cast<std::streamsize>(line.size())) &&
    line == GetLastLine(fileName, before);
}

/// What a reader or a writer says of a file is said by who uses it, once.
inline void Silence(vtkAlgorithm* algorithm)
{
  vtkNew<vtkCallbackCommand> silence;
  algorithm->AddObserver(vtkCommand::ErrorEvent, silence);
  algorithm->AddObserver(vtkCommand::WarningEvent, silence);
  algorithm->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, silence);
}

/// Writes the input of a writer, with data compressed and in text: with expat 2.5.0-1+deb12u2,
/// which Debian 12 has been updated to, ParaView 5.11 fails to read bytes that are appended.
/// Returns whether that was possible.
inline bool Write(vtkXMLWriter* writer, const std::string& fileName)
{
  Silence(writer);
  writer->SetFileName(GetTemporaryName(fileName).c_str());
  writer->SetDataModeToBinary();
  writer->SetHeaderTypeToUInt64();
  writer->SetCompressorTypeToLZ4();
  return Finish(fileName,
    writer->Write() != 0 && writer->GetErrorCode() == 0 && Seal(GetTemporaryName(fileName)));
}

/// Reads a file. Returns whether it is whole as far as the reader can tell.
inline bool Read(vtkXMLReader* reader, const std::string& fileName)
{
  if (!IsSealed(fileName))
  {
    return false;
  }
  // The parser's errors are in no error code.
  bool isWhole = true;
  vtkNew<vtkCallbackCommand> note;
  note->SetClientData(&isWhole);
  note->SetCallback(
    [](vtkObject*, unsigned long, void* client, void*) { *static_cast<bool*>(client) = false; });
  Silence(reader);
  reader->AddObserver(vtkCommand::ErrorEvent, note);
  reader->SetParserErrorObserver(note);
  reader->SetFileName(fileName.c_str());
  reader->Update();
  reader->RemoveObserver(note);
  reader->SetParserErrorObserver(nullptr);
  return isWhole && reader->GetErrorCode() == 0;
}
}

}

#endif
