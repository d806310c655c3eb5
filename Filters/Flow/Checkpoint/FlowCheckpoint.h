// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FlowCheckpoint_h
#define interlume_FlowCheckpoint_h

#include "Checkpoint/FlowFingerprint.h"
#include "Checkpoint/StreamlineRecord.h"

#include "vtkType.h"

#include <chrono>
#include <functional>
#include <string>

namespace interlume
{

class RankExchange;

/**
 * @class   FlowCheckpoint
 * @brief   checkpoint file with the finished streamlines of an execution of vtkImplicitFlowField
 *
 * The file is a vtkTable in VTK's XML format. StreamlineRecord defines the columns of the table.
 * The field data contain the FlowFingerprint, a marker array (PartialImplicitFlow) and digests. A
 * new file is written under a temporary name and then renamed. Therefore an interrupted write never
 * damages the previous file.
 */
class FlowCheckpoint
{
public:
  using Warn = std::function<void(const std::string&)>;

  /// \a interval is the minimum number of seconds between two writes. \a means is the number of
  /// averaged arrays. \a warn is called with each warning.
  FlowCheckpoint(const std::string& fileName, double interval, FlowFingerprint&& fingerprint,
    int means, Warn&& warn);

  /// Returns the name of the checkpoint file of a piece. \a pieces is the number of pieces.
  static std::string GetPieceName(const std::string& fileName, int piece, int pieces);

  /// Reads the file if it exists. If the field is distributed, \a exchange connects the processes,
  /// and all of them must call this function. If one process rejects its file, all processes do.
  void Open(RankExchange* exchange);

  StreamlineRecord& GetRecord() { return this->Record; }

  ///@{
  /// Returns the number of streamlines read from the file, and the number of files written.
  vtkIdType GetNumberOfResumed() const { return this->Resumed; }
  void AddResumed(vtkIdType number) { this->Resumed += number; }
  vtkIdType GetNumberOfFiles() const { return this->Files; }
  ///@}

  /// Warns that the recorded results of the current group belong to other streamlines, so that they
  /// and all later results are not used.
  void WarnOfMismatch();

  /// Returns true if the interval since the last write has elapsed. A positive interval is extended
  /// to at least ten times the duration of the last write.
  bool IsDue() const;
  /// Writes the file if there are new results.
  void Write();
  /// Removes the file if this execution wrote it or resumed from it.
  void Remove();

private:
  using Clock = std::chrono::steady_clock;

  /// Reads the file. If the file cannot be used, returns the reason as a clause.
  Error Read();

  std::string FileName;
  double Interval;
  FlowFingerprint CurrentFingerprint;
  StreamlineRecord Record;
  Warn WarnUser;
  /// True if this execution wrote the file or resumed from it.
  bool IsOwn = false;
  /// True if no file may be written, because FileName names a file that is not a checkpoint, or
  /// because the directory is not writable.
  bool IsWritingDisabled = false;
  bool HasFailed = false;
  vtkIdType RowsInFile = 0;
  vtkIdType Resumed = 0;
  vtkIdType Files = 0;
  Clock::time_point Last = Clock::now();
  double WritingSeconds = 0.0;
};

}

#endif
