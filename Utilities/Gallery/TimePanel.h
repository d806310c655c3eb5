// SPDX-License-Identifier: BSD-3-Clause
#ifndef TimePanel_h
#define TimePanel_h

#include <vector>

class vtkAlgorithm;
class vtkColorTransferFunction;

namespace gallery
{
class Panel;
class Stage;

/**
 * Returns the times of the steps of a temporal source.
 */
std::vector<double> GetTimeSteps(vtkAlgorithm* source);

/**
 * Halves the green of a vtkTemporalColorTransferFunction, so that the colors of all times add up to
 * gray. Blue, green and red then have the same mean over time.
 */
void BalanceColors(vtkColorTransferFunction* colors);

/**
 * Adds a dark panel that shows where the scalars of \a source are between \a lower and \a upper,
 * over all times from its first to its last step. Colors of different times, balanced by
 * BalanceColors(), are blended additively. \a extinction is per unit of length and time. Sets the
 * color bar of the stage.
 */
Panel& AddTimePanel(
  Stage& stage, vtkAlgorithm* source, double lower, double upper, double extinction);
}

#endif
