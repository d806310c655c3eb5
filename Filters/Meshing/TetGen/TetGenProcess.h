// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TetGenProcess_h
#define interlume_TetGenProcess_h

#include "Common/Error.h"
#include "TetGen/TetGenProblem.h"

#include <cstdio>
#include <functional>
#include <string>

#include <sys/types.h>

namespace interlume
{

/**
 * @class   TetGenProcess
 * @brief   runs TetGen in a separate process
 *
 * TetGen 1.5 may free memory twice after throwing an exception, fail an assertion, recurse without
 * limit, or not terminate. Therefore it runs in a small program, the worker. The worker is started
 * for the first problem, reused for later problems, and restarted after a failure. The global state
 * of TetGen's predicates and random numbers is confined to the worker process. posix_spawn is used
 * because it is safe in a process with threads. The calling process receives no signal. TetGen's
 * output is written to a temporary file.
 */
class TetGenProcess
{
public:
  /// Sets the path of the worker. If empty, the worker next to this module's library is used.
  explicit TetGenProcess(const std::string& program);
  ~TetGenProcess();
  TetGenProcess(const TetGenProcess&) = delete;
  void operator=(const TetGenProcess&) = delete;

  /// Callback that returns true to stop TetGen. It is called about ten times per second while
  /// TetGen runs.
  std::function<bool()> IsCanceled;
  /// Maximum time for one problem, in seconds; 0 for no limit.
  double TimeLimit = 0.0;

  /// Runs TetGen. Returns an error if there is no solution. A canceled run returns no error.
  Error Solve(const TetGenProblem& problem, TetGenSolution& solution);
  /// Returns whether the last problem took longer than TimeLimit.
  bool HasTimedOut() const { return this->TimedOut; }

private:
  Error Start();
  Error Spawn(int workerSocket);
  /// Stops the worker and returns a description of how it ended.
  std::string Stop();
  std::string GetLastOutput() const;

  std::string Program;
  bool TimedOut = false;
  pid_t Process = -1;
  int Socket = -1;
  std::FILE* Output = nullptr;
};

}

#endif
