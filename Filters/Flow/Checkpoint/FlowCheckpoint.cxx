// SPDX-License-Identifier: BSD-3-Clause
#include "Checkpoint/FlowCheckpoint.h"

#include "Streams/RankExchange.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkTable.h"
#include "vtkXMLTableReader.h"
#include "vtkXMLTableWriter.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <utility>

namespace interlume
{

namespace
{
// It is the first word of the file's field data, and means that streamlines are missing.
constexpr const char* MarkArray = "PartialImplicitFlow";

/// Names are in UTF-8, as VTK has them.
std::filesystem::path GetPath(const std::string& fileName)
{
  return std::filesystem::u8path(fileName);
}

void RemoveFile(const std::string& fileName)
{
  // That there is none is nothing wrong.
  std::error_code ignored;
  std::filesystem::remove(GetPath(fileName), ignored);
}

bool RenameFile(const std::string& fileName, const std::string& other)
{
  std::error_code wrong;
  std::filesystem::rename(GetPath(fileName), GetPath(other), wrong);
  return !wrong;
}

double GetSeconds(std::chrono::steady_clock::duration duration)
{
  return std::chrono::duration<double>(duration).count();
}

/// Returns whether a file begins as those that are written here, whole or not.
bool IsCheckpoint(const std::string& fileName)
{
  std::ifstream file(GetPath(fileName), std::ios::in | std::ios::binary);
  std::string head(1024, '\0');
  file.read(&head[0], static_cast<std::streamsize>(head.size()));
  return head.find(std::string("Name=\"") + MarkArray + "\"") != std::string::npos;
}

/// What a reader or a writer says of a file is said by the filter, once.
void Silence(vtkAlgorithm* algorithm)
{
  vtkNew<vtkCallbackCommand> silence;
  algorithm->AddObserver(vtkCommand::ErrorEvent, silence);
  algorithm->AddObserver(vtkCommand::WarningEvent, silence);
  algorithm->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, silence);
}
}

FlowCheckpoint::FlowCheckpoint(const std::string& fileName, double interval,
  FlowFingerprint&& fingerprint, int means, Warn&& warn)
  : FileName(fileName)
  , Interval(interval)
  , Own(std::move(fingerprint))
  , Record(means)
  , Tell(std::move(warn))
{
}

std::string FlowCheckpoint::GetPieceName(const std::string& fileName, int piece, int pieces)
{
  if (pieces < 2)
  {
    return fileName;
  }
  const std::string extension = GetPath(fileName).extension().u8string();
  return fileName.substr(0, fileName.size() - extension.size()) + "_" + std::to_string(piece) +
    extension;
}

std::string FlowCheckpoint::Read()
{
  if (!IsCheckpoint(this->FileName))
  {
    this->IsBarred = true;
    return "it is no checkpoint of an implicit flow field. It is left as it is, and none is "
           "written";
  }
  vtkNew<vtkXMLTableReader> reader;
  Silence(reader);
  vtkNew<vtkCallbackCommand> silence;
  reader->SetParserErrorObserver(silence);
  reader->SetFileName(this->FileName.c_str());
  reader->Update();
  vtkTable* table = reader->GetOutput();
  if (reader->GetErrorCode() != 0 || !table->GetFieldData()->GetArray(MarkArray))
  {
    return "it is damaged or not whole";
  }
  const std::string different = this->Own.Compare(table->GetFieldData());
  if (!different.empty())
  {
    return "these differ: " + different;
  }
  const std::string wrong = this->Record.Read(table);
  return wrong.empty() ? wrong : "it is damaged, " + wrong;
}

void FlowCheckpoint::Open(RankExchange* exchange)
{
  std::error_code ignored;
  const bool isThere = std::filesystem::exists(GetPath(this->FileName), ignored);
  std::string wrong = isThere ? this->Read() : std::string();
  wrong = wrong.empty() ? wrong : "The checkpoint " + this->FileName + " is not used: " + wrong;
  const std::string anywhere = exchange ? exchange->FindFirst(wrong) : wrong;
  if (!anywhere.empty())
  {
    this->Record.Clear();
    this->Tell((wrong.empty() ? anywhere : wrong) + ". All streamlines are followed anew.");
  }
  this->IsOwn = isThere && anywhere.empty();
  this->RowsInFile = this->Record.GetNumberOfRows();
  // Hours later would be late to learn that there is no such folder.
  const std::string temporary = this->GetTemporaryName();
  if (!this->IsBarred && !std::ofstream(GetPath(temporary)))
  {
    this->IsBarred = true;
    this->Tell("No checkpoint is written: the file " + temporary + " cannot be made.");
  }
  RemoveFile(temporary);
  this->Last = Clock::now();
}

void FlowCheckpoint::WarnOfOther()
{
  this->Tell("A part of the checkpoint " + this->FileName +
    " is not used: the streamlines there begin elsewhere. They are followed anew.");
}

bool FlowCheckpoint::IsDue() const
{
  constexpr double share = 10.0;
  const double interval =
    this->Interval > 0.0 ? std::max(this->Interval, share * this->WritingSeconds) : 0.0;
  return GetSeconds(Clock::now() - this->Last) >= interval;
}

void FlowCheckpoint::Write()
{
  if (this->IsBarred || this->Record.GetNumberOfRows() == this->RowsInFile)
  {
    return;
  }
  const Clock::time_point start = Clock::now();
  vtkNew<vtkTable> table;
  vtkNew<vtkIntArray> mark;
  mark->SetName(MarkArray);
  mark->InsertNextValue(1);
  table->GetFieldData()->AddArray(mark);
  this->Own.Write(table->GetFieldData());
  this->Record.Write(table);
  vtkNew<vtkXMLTableWriter> writer;
  Silence(writer);
  const std::string temporary = this->GetTemporaryName();
  writer->SetFileName(temporary.c_str());
  writer->SetInputData(table);
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetHeaderTypeToUInt64();
  writer->SetCompressorTypeToLZ4();
  const bool isWritten =
    writer->Write() != 0 && writer->GetErrorCode() == 0 && RenameFile(temporary, this->FileName);
  this->IsOwn = this->IsOwn || isWritten;
  if (isWritten)
  {
    ++this->Files;
    this->RowsInFile = this->Record.GetNumberOfRows();
  }
  else
  {
    RemoveFile(temporary);
  }
  if (!isWritten && !this->HasFailed)
  {
    this->HasFailed = true;
    this->Tell("The checkpoint " + this->FileName +
      " could not be written. One that was there before is as it was.");
  }
  this->Last = Clock::now();
  this->WritingSeconds = GetSeconds(this->Last - start);
}

void FlowCheckpoint::Remove()
{
  if (this->IsOwn)
  {
    RemoveFile(this->FileName);
  }
}

}
