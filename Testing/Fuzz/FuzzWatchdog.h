// SPDX-License-Identifier: BSD-3-Clause
#ifndef FuzzWatch_h
#define FuzzWatch_h

#include <chrono>             // for the duration of a case
#include <condition_variable> // to end the thread
#include <mutex>              // to protect the current case
#include <string>             // for names
#include <thread>             // for the watching thread

namespace fuzz
{

/**
 * @class   FuzzWatchdog
 * @brief   reports the progress of a run and ends a case that takes too long
 *
 * A separate thread prints a line to the error stream every ten seconds, so that a long case can be
 * identified while it runs. If a case takes longer than the limit, the program prints the arguments
 * of the case and exits with an error.
 */
class FuzzWatchdog
{
public:
  /// Sets the maximum wall-clock time of a case, in seconds.
  explicit FuzzWatchdog(double limit);
  ~FuzzWatchdog();
  FuzzWatchdog(const FuzzWatchdog&) = delete;
  FuzzWatchdog& operator=(const FuzzWatchdog&) = delete;

  /// Starts a case: \a arguments reproduce it and \a done is the number of finished cases.
  void Begin(const std::string& arguments, int done, int count);

  /// Ends the case. The limit applies again from the next call of Begin.
  void End();

private:
  using Clock = std::chrono::steady_clock;

  void Run();

  const std::chrono::duration<double> Limit;
  const Clock::time_point Start = Clock::now();
  std::mutex Mutex;
  std::condition_variable Changed;
  std::string Arguments;
  int Done = 0;
  int Count = 0;
  bool IsInCase = false;
  bool IsOver = false;
  Clock::time_point CaseStart;
  std::thread Thread;
};

}

#endif
