// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_AtomicFiles_h
#define interlume_AtomicFiles_h

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
 * Reads files in VTK's XML formats, and writes them atomically. A file is written under a temporary
 * name and then renamed. If the process is killed while writing, the previous file remains intact.
 * A comment at the end of the file contains a digest of the preceding bytes, so that damage is
 * detected before a reader parses the file. File names are in UTF-8, as in VTK.
 */
namespace AtomicFiles
{
inline std::filesystem::path GetPath(const std::string& fileName)
{
  return std::filesystem::u8path(fileName);
}

inline std::string GetTemporaryName(const std::string& fileName)
{
  return fileName + ".part";
}

inline bool Exists(const std::string& fileName)
{
  std::error_code ignored;
  return std::filesystem::exists(GetPath(fileName), ignored);
}

inline void Remove(const std::string& fileName)
{
  // A missing file is not an error.
  std::error_code ignored;
  std::filesystem::remove(GetPath(fileName), ignored);
}

/// Renames the temporary file to \a fileName, or removes it if \a isWritten is false. Returns
/// whether the file was replaced.
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

/// Returns whether the temporary file can be created. Removes it, even if an earlier process
/// created it.
inline bool CanWrite(const std::string& fileName)
{
  const bool can = static_cast<bool>(std::ofstream(GetPath(GetTemporaryName(fileName))));
  Remove(GetTemporaryName(fileName));
  return can;
}

/// Returns the last line of a sealed file: a comment with the digest of all preceding bytes, whose
/// number is \a bytes. Returns an empty string if the file is shorter.
inline std::string MakeDigestLine(const std::string& fileName, std::uintmax_t bytes)
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

/// Appends the comment with the digest to a file. Returns false on failure.
inline bool AppendDigest(const std::string& fileName)
{
  std::error_code error;
  const std::uintmax_t bytes = std::filesystem::file_size(GetPath(fileName), error);
  const std::string line = error ? std::string() : MakeDigestLine(fileName, bytes);
  std::ofstream file(GetPath(fileName), std::ios::out | std::ios::binary | std::ios::app);
  file << line << std::flush;
  return !line.empty() && file;
}

/// Returns whether a file matches its digest.
inline bool HasValidDigest(const std::string& fileName)
{
  std::string line = MakeDigestLine(fileName, 0);
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
    line == MakeDigestLine(fileName, before);
}

/// Suppresses the messages of a reader or writer. The caller must report failures itself.
inline void Silence(vtkAlgorithm* algorithm)
{
  vtkNew<vtkCallbackCommand> silence;
  algorithm->AddObserver(vtkCommand::ErrorEvent, silence);
  algorithm->AddObserver(vtkCommand::WarningEvent, silence);
  algorithm->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, silence);
}

/// Writes the input of \a writer, compressed and base64-encoded. Appended data is not used, since
/// ParaView 5.11 cannot read it with expat 2.5.0-1+deb12u2 of Debian 12. Returns false on failure.
inline bool Write(vtkXMLWriter* writer, const std::string& fileName)
{
  Silence(writer);
  writer->SetFileName(GetTemporaryName(fileName).c_str());
  writer->SetDataModeToBinary();
  writer->SetHeaderTypeToUInt64();
  writer->SetCompressorTypeToLZ4();
  return Finish(fileName,
    writer->Write() != 0 && writer->GetErrorCode() == 0 &&
      AppendDigest(GetTemporaryName(fileName)));
}

/// Reads a file. Returns false if the file is damaged or the reader reports an error.
inline bool Read(vtkXMLReader* reader, const std::string& fileName)
{
  if (!HasValidDigest(fileName))
  {
    return false;
  }
  // Parser errors do not set an error code.
  bool isIntact = true;
  vtkNew<vtkCallbackCommand> note;
  note->SetClientData(&isIntact);
  note->SetCallback(
    [](vtkObject*, unsigned long, void* client, void*) { *static_cast<bool*>(client) = false; });
  Silence(reader);
  reader->AddObserver(vtkCommand::ErrorEvent, note);
  reader->SetParserErrorObserver(note);
  reader->SetFileName(fileName.c_str());
  reader->Update();
  reader->RemoveObserver(note);
  reader->SetParserErrorObserver(nullptr);
  return isIntact && reader->GetErrorCode() == 0;
}
}

}

#endif
