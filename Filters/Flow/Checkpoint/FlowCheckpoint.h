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
 * @brief   the file that has the finished streamlines of an execution of vtkImplicitFlowField
 *
 * A vtkTable of VTK's XML format: the columns of StreamlineRecord, and in the field data the
 * FlowFingerprint, the mark Partial and digests. It is written beside itself and then renamed, so
 * that there is a whole one at any time.
 */
class FlowCheckpoint
{
public:
  using Warn = std::function<void(const std::string&)>;

  /// \a interval is the least number of seconds between two files; \a warn takes warnings about a
  /// file.
  FlowCheckpoint(const std::string& fileName, double interval, FlowFingerprint&& fingerprint,
    int means, Warn&& warn);

  /// Returns the name of the file of one of several pieces.
  static std::string GetPieceName(const std::string& fileName, int piece, int pieces);

  /// Reads the file, if there is one. Collective where processes have parts of the field, \a
  /// exchange then is theirs: what any of them refuses, all do.
  void Open(RankExchange* exchange);

  StreamlineRecord& GetRecord() { return this->Record; }

  ///@{
  /// Returns the number of streamlines that were not followed since the file has them, and of files
  /// that were written.
  vtkIdType GetNumberOfResumed() const { return this->Resumed; }
  void AddResumed(vtkIdType number) { this->Resumed += number; }
  vtkIdType GetNumberOfFiles() const { return this->Files; }
  ///@}

  /// Warns that what is recorded from a group of streamlines on is of others.
  void WarnOfOther();

  /// Returns whether the interval is over. After a file that took long to write it is ten times as
  /// long as that.
  bool IsDue() const;
  /// Writes the file, if it does not have what is recorded.
  void Write();
  /// Removes the file, if it is this execution's.
  void Remove();

private:
  using Clock = std::chrono::steady_clock;

  /// Reads the file. Returns an error, whose message is a part of a sentence, if the file cannot be
  /// used.
  Error Read();

  std::string FileName;
  double Interval;
  /// What this execution depends on.
  FlowFingerprint Own;
  StreamlineRecord Record;
  Warn Tell;
  /// Whether there may be a file that was written here, or resumed from.
  bool IsOwn = false;
  /// Whether no file may be written, since another one has the name or there is no such place.
  bool IsBarred = false;
  bool HasFailed = false;
  vtkIdType RowsInFile = 0;
  vtkIdType Resumed = 0;
  vtkIdType Files = 0;
  Clock::time_point Last = Clock::now();
  double WritingSeconds = 0.0;
};

}

#endif
