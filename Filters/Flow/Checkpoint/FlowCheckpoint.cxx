// SPDX-License-Identifier: BSD-3-Clause
#include "Checkpoint/FlowCheckpoint.h"

#include "Common/AtomicFiles.h"
#include "Streams/RankExchange.h"

#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkTable.h"
#include "vtkXMLTableReader.h"
#include "vtkXMLTableWriter.h"

#include <algorithm>
#include <fstream>
#include <utility>

namespace interlume
{

namespace
{
// Name of the first field data array, which identifies the file as a checkpoint.
constexpr const char* MarkArray = "PartialImplicitFlow";

double GetSeconds(std::chrono::steady_clock::duration duration)
{
  return std::chrono::duration<double>(duration).count();
}

/// Returns true if the start of the file is that of a checkpoint. The rest may be damaged.
bool IsCheckpoint(const std::string& fileName)
{
  std::ifstream file(AtomicFiles::GetPath(fileName), std::ios::in | std::ios::binary);
  std::string head(1024, '\0');
  file.read(&head[0], static_cast<std::streamsize>(head.size()));
  return head.find(std::string("Name=\"") + MarkArray + "\"") != std::string::npos;
}
}

FlowCheckpoint::FlowCheckpoint(const std::string& fileName, double interval,
  FlowFingerprint&& fingerprint, int means, Warn&& warn)
  : FileName(fileName)
  , Interval(interval)
  , CurrentFingerprint(std::move(fingerprint))
  , Record(means)
  , WarnUser(std::move(warn))
{
}

std::string FlowCheckpoint::GetPieceName(const std::string& fileName, int piece, int pieces)
{
  if (pieces < 2)
  {
    return fileName;
  }
  const std::string extension = AtomicFiles::GetPath(fileName).extension().u8string();
  return fileName.substr(0, fileName.size() - extension.size()) + "_" + std::to_string(piece) +
    extension;
}

Error FlowCheckpoint::Read()
{
  if (!IsCheckpoint(this->FileName))
  {
    this->IsWritingDisabled = true;
    return { "it is not a checkpoint of vtkImplicitFlowField. The file remains unchanged and no "
             "checkpoint is written; set another CheckpointFileName",
      ErrorCode::File };
  }
  vtkNew<vtkXMLTableReader> reader;
  const bool isRead = AtomicFiles::Read(reader, this->FileName);
  vtkTable* table = reader->GetOutput();
  if (!isRead || !table->GetFieldData()->GetArray(MarkArray))
  {
    return { "it is damaged or incomplete", ErrorCode::File };
  }
  const std::string different = this->CurrentFingerprint.Compare(table->GetFieldData());
  if (!different.empty())
  {
    return "it differs in " + different;
  }
  return this->Record.Read(table).Within("it is damaged, ");
}

void FlowCheckpoint::Open(RankExchange* exchange)
{
  const bool exists = AtomicFiles::Exists(this->FileName);
  const Error error = (exists ? this->Read() : Error())
                        .Within("The checkpoint " + this->FileName + " is not used: ",
                          ". All streamlines are computed again.");
  const Error anywhere = exchange ? exchange->FindFirst(error) : error;
  if (anywhere)
  {
    this->Record.Clear();
    this->WarnUser((error ? error : anywhere).GetMessage());
  }
  this->IsOwn = exists && !anywhere;
  this->RowsInFile = this->Record.GetNumberOfRows();
  // Checks now whether files can be written, so that the user need not wait until the first write
  // is due.
  if (!this->IsWritingDisabled && !AtomicFiles::CanWrite(this->FileName))
  {
    this->IsWritingDisabled = true;
    this->WarnUser("No checkpoint is written: the file " +
      AtomicFiles::GetTemporaryName(this->FileName) +
      " cannot be created. Check that the directory exists and is writable.");
  }
  this->Last = Clock::now();
}

void FlowCheckpoint::WarnOfMismatch()
{
  this->WarnUser("Some results in the checkpoint " + this->FileName +
    " are not used because their streamlines have other start positions. These streamlines are "
    "computed again.");
}

bool FlowCheckpoint::IsDue() const
{
  constexpr double factor = 10.0;
  const double interval =
    this->Interval > 0.0 ? std::max(this->Interval, factor * this->WritingSeconds) : 0.0;
  return GetSeconds(Clock::now() - this->Last) >= interval;
}

void FlowCheckpoint::Write()
{
  if (this->IsWritingDisabled || this->Record.GetNumberOfRows() == this->RowsInFile)
  {
    return;
  }
  const Clock::time_point start = Clock::now();
  vtkNew<vtkTable> table;
  vtkNew<vtkIntArray> mark;
  mark->SetName(MarkArray);
  mark->InsertNextValue(1);
  table->GetFieldData()->AddArray(mark);
  this->CurrentFingerprint.Write(table->GetFieldData());
  this->Record.Write(table);
  vtkNew<vtkXMLTableWriter> writer;
  writer->SetInputData(table);
  const bool isWritten = AtomicFiles::Write(writer, this->FileName);
  this->IsOwn = this->IsOwn || isWritten;
  if (isWritten)
  {
    ++this->Files;
    this->RowsInFile = this->Record.GetNumberOfRows();
  }
  if (!isWritten && !this->HasFailed)
  {
    this->HasFailed = true;
    this->WarnUser("The checkpoint " + this->FileName +
      " could not be written. An earlier checkpoint file remains unchanged. Check the free disk "
      "space and the permissions.");
  }
  this->Last = Clock::now();
  this->WritingSeconds = GetSeconds(this->Last - start);
}

void FlowCheckpoint::Remove()
{
  if (this->IsOwn)
  {
    AtomicFiles::Remove(this->FileName);
  }
}

}
