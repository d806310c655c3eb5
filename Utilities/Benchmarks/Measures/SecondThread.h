#ifndef SecondThread_h
#define SecondThread_h

#include "BenchOptions.h"
#include "BenchRow.h"
#include "BenchTiming.h"

/**
 * Fills in the seconds of \a work by two threads, and by one as the peer `threads-1`.
 */
void MeasureSecondThread(const BenchWork& work, const BenchOptions& options, BenchRow& row);

#endif
