// SPDX-License-Identifier: BSD-3-Clause
#ifndef ResidentMemory_h
#define ResidentMemory_h

#include <optional>

///@{
/**
 * Resident memory of this process in KiB, now and at its highest since ForgetPeakMemory(); nothing
 * where the system cannot tell.
 */
std::optional<long> ResidentKib();
std::optional<long> PeakResidentKib();
///@}

/**
 * Gives freed memory back and starts the high-water mark of the resident memory anew.
 */
void ForgetPeakMemory();

#endif
