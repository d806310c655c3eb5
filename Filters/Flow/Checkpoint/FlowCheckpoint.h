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
 * The file is a vtkTable in VTK's XML format. StreamlineRecord defines its columns. Its field
 * data contain the FlowFingerprint, a marker array (PartialImplicitFlow) and digests. A new file is
 * written under a temporary name and then renamed. Therefore an interrupted write never damages the
 * previous file.
 */
class FlowCheckpoint
{
public:
  using Warn = std::function<void(const std::string&)>;

  /// \a interval is the minimum number of seconds between two writes. \a means is the number of
  /// averaged arrays. \a warn is called with each warning.
  FlowCheckpoint(const std::string& fileName, double interval, FlowFingerprint&& fingerprint,
    int means, Warn&& warn);

  /// Returns the name of the file for one of \a pieces pieces.
  static std::string GetPieceName(const std::string& fileName, int piece, int pieces);

  /// Reads the file if it exists. If processes hold partitions of the field, pass their \a
  /// exchange; the call is then collective. If one process rejects its file, all processes do.
  void Open(RankExchange* exchange);

  StreamlineRecord& GetRecord() { return this->Record; }

  ///@{
  /// Returns the number of streamlines read from the file, and the number of files written.
  vtkIdType GetNumberOfResumed() const { return this->Resumed; }
  void AddResumed(vtkIdType number) { this->Resumed += number; }
  vtkIdType GetNumberOfFiles() const { return this->Files; }
  ///@}

  /// Warns that, from the current group on, the recorded results belong to other streamlines.
  void WarnOfMismatch();

  /// Returns true if the interval has elapsed. The interval is at least ten times the duration of
  /// the last write.
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
  /// Fingerprint of this execution.
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
