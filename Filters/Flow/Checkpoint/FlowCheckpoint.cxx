// SPDX-License-Identifier: BSD-3-Clause
#include "Checkpoint/FlowCheckpoint.h"

#include "Common/WholeFiles.h"
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
// It is the first word of the file's field data, and means that streamlines are missing.
constexpr const char* MarkArray = "PartialImplicitFlow";

double GetSeconds(std::chrono::steady_clock::duration duration)
{
  return std::chrono::duration<double>(duration).count();
}

/// Returns whether a file begins as those that are written here, whole or not.
bool IsCheckpoint(const std::string& fileName)
{
  std::ifstream file(WholeFiles::GetPath(fileName), std::ios::in | std::ios::binary);
  std::string head(1024, '\0');
  file.read(&head[0], static_cast<std::streamsize>(head.size()));
  return head.find(std::string("Name=\"") + MarkArray + "\"") != std::string::npos;
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
  const std::string extension = WholeFiles::GetPath(fileName).extension().u8string();
  return fileName.substr(0, fileName.size() - extension.size()) + "_" + std::to_string(piece) +
    extension;
}

Error FlowCheckpoint::Read()
{
  if (!IsCheckpoint(this->FileName))
  {
    this->IsBarred = true;
    return { "it is no checkpoint of an implicit flow field. It is left as it is, and none is "
             "written",
      ErrorCode::File };
  }
  vtkNew<vtkXMLTableReader> reader;
  const bool isRead = WholeFiles::Read(reader, this->FileName);
  vtkTable* table = reader->GetOutput();
  if (!isRead || !table->GetFieldData()->GetArray(MarkArray))
  {
    return { "it is damaged or not whole", ErrorCode::File };
  }
  const std::string different = this->Own.Compare(table->GetFieldData());
  if (!different.empty())
  {
    return "these differ: " + different;
  }
  return this->Record.Read(table).Within("it is damaged, ");
}

void FlowCheckpoint::Open(RankExchange* exchange)
{
  const bool isThere = WholeFiles::IsThere(this->FileName);
  const Error error = (isThere ? this->Read() : Error())
                        .Within("The checkpoint " + this->FileName + " is not used: ",
                          ". All streamlines are followed anew.");
  const Error anywhere = exchange ? exchange->FindFirst(error) : error;
  if (anywhere)
  {
    this->Record.Clear();
    this->Tell((error ? error : anywhere).GetMessage());
  }
  this->IsOwn = isThere && !anywhere;
  this->RowsInFile = this->Record.GetNumberOfRows();
  // Hours later would be late to learn that there is no such folder.
  if (!this->IsBarred && !WholeFiles::CanWrite(this->FileName))
  {
    this->IsBarred = true;
    this->Tell("No checkpoint is written: the file " +
      WholeFiles::GetTemporaryName(this->FileName) + " cannot be made.");
  }
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
  writer->SetInputData(table);
  const bool isWritten = WholeFiles::Write(writer, this->FileName);
  this->IsOwn = this->IsOwn || isWritten;
  if (isWritten)
  {
    ++this->Files;
    this->RowsInFile = this->Record.GetNumberOfRows();
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
    WholeFiles::Remove(this->FileName);
  }
}

}
