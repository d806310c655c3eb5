// SPDX-License-Identifier: BSD-3-Clause
#ifndef TransportEstimate_h
#define TransportEstimate_h

namespace reference
{

/**
 * A mean over paths and its standard error.
 */
struct TransportEstimate
{
  double Value = 0.0;
  double StandardError = 0.0;
};

}

#endif
