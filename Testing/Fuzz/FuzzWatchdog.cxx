// SPDX-License-Identifier: BSD-3-Clause
#include "FuzzWatchdog.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>

namespace fuzz
{

namespace
{
constexpr std::chrono::seconds Pause(10);
}

FuzzWatchdog::FuzzWatchdog(double limit)
  : Limit(limit)
  , Thread([this]() { this->Run(); })
{
}

FuzzWatchdog::~FuzzWatchdog()
{
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->IsOver = true;
  }
  this->Changed.notify_one();
  this->Thread.join();
}

void FuzzWatchdog::Begin(const std::string& arguments, int done, int count)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->Arguments = arguments;
  this->Done = done;
  this->Count = count;
  this->CaseStart = Clock::now();
  this->IsInCase = true;
  this->Changed.notify_one();
}

void FuzzWatchdog::End()
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->IsInCase = false;
}

void FuzzWatchdog::Run()
{
  using Seconds = std::chrono::duration<double>;
  const auto limit = std::chrono::duration_cast<Clock::duration>(this->Limit);
  Clock::time_point next = this->Start + Pause;
  std::unique_lock<std::mutex> lock(this->Mutex);
  while (!this->IsOver)
  {
    this->Changed.wait_until(lock, this->IsInCase ? std::min(next, this->CaseStart + limit) : next);
    const Clock::time_point now = Clock::now();
    const Seconds inCase = now - this->CaseStart;
    if (this->IsInCase && inCase >= this->Limit)
    {
      std::cerr << this->Arguments << " did not end in " << this->Limit.count() << " seconds"
                << std::endl;
      // Exit without destructors, which would wait for the case.
      std::_Exit(EXIT_FAILURE);
    }
    if (now >= next)
    {
      next = now + Pause;
      std::cerr << std::lround(Seconds(now - this->Start).count()) << " s: " << this->Done << " of "
                << this->Count << " cases, at " << this->Arguments << " for "
                << (this->IsInCase ? std::lround(inCase.count()) : 0) << " s" << std::endl;
    }
  }
}

}
