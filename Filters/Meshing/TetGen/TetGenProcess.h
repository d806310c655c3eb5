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
 * @brief   TetGen in a process of its own
 *
 * TetGen 1.5 throws from functions whose destructors then free memory twice, has assertions, can
 * recurse without end and can fail to terminate. So it runs in a small program, started at the
 * first problem and kept for the next ones; after a failure a new one is started. TetGen's
 * predicates and random numbers have global state: there it is private. The program is started with
 * posix_spawn, so that this is safe in a process with threads. No signal reaches the caller's
 * process, and what TetGen prints goes to a temporary file.
 */
class TetGenProcess
{
public:
  /// Takes the path of the worker; empty for the one beside this module's library.
  explicit TetGenProcess(const std::string& program);
  ~TetGenProcess();
  TetGenProcess(const TetGenProcess&) = delete;
  void operator=(const TetGenProcess&) = delete;

  /// A function that is asked some ten times a second while TetGen works; true ends it.
  std::function<bool()> IsCancelled;
  /// The longest time for one problem, in seconds; 0 for none.
  double TimeLimit = 0.0;

  /// Runs TetGen. Returns an error if there is no solution. A canceled run has no error.
  Error Solve(const TetGenProblem& problem, TetGenSolution& solution);
  /// Returns whether the last problem took longer than TimeLimit.
  bool IsLate() const { return this->Late; }

private:
  Error Start();
  Error Spawn(int workerSocket);
  /// Ends the worker. Returns how it ended.
  std::string Stop();
  std::string GetLastOutput() const;

  std::string Program;
  bool Late = false;
  pid_t Process = -1;
  int Socket = -1;
  std::FILE* Output = nullptr;
};

}

#endif
