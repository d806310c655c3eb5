// SPDX-License-Identifier: BSD-3-Clause
#ifndef ResidentMemory_h
#define ResidentMemory_h

#include <optional>

///@{
/**
 * Return the current resident memory of this process in KiB, and its maximum since
 * ResetPeakMemory(). The result is empty if the system does not report it.
 */
std::optional<long> ResidentKib();
std::optional<long> PeakResidentKib();
///@}

/**
 * Returns freed memory to the system and resets the high-water mark of the resident memory.
 */
void ResetPeakMemory();

#endif
