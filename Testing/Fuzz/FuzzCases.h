// SPDX-License-Identifier: BSD-3-Clause
#ifndef FuzzCases_h
#define FuzzCases_h

#include "FuzzRandom.h" // for choices

#include "Support/Checks/ReferenceCheck.h" // for the result

#include <string> // for names
#include <vector> // for the list

/**
 * Families of random test cases. Each function creates data and a pipeline from a random generator,
 * checks the results, and stores its choices in \a text for messages.
 */
namespace fuzz
{

/// Checks vtkIntervalVolume with criteria, boundaries and origins. On tame data, the volumes of
/// adjacent intervals add up to the volume of their union. Changing the intervals and restoring
/// them reproduces the output.
void RunIntervals(FuzzRandom& random, std::string& text, reference::Check& check);

/// Checks that all points of vtkIsotableContour have one of the isovalues.
void RunContours(FuzzRandom& random, std::string& text, reference::Check& check);

/// Checks vtkTimeVaryingIntervalVolume and vtkSimplexTimeSlice on time steps of one grid.
void RunTime(FuzzRandom& random, std::string& text, reference::Check& check);

/// Checks vtkImplicitFlowField, vtkInflowMapping and vtkFlowVolume: statuses must be valid.
void RunFlow(FuzzRandom& random, std::string& text, reference::Check& check);

/// Checks that filters reject inconsistent grids with an error that names the fault.
void RunDamage(FuzzRandom& random, std::string& text, reference::Check& check);

/// Checks damaged checkpoints and slabs: they must be reported and must not change the output.
void RunFiles(FuzzRandom& random, std::string& text, reference::Check& check);

/// Checks that images of vtkTimeWeightedTetrahedraMapper are finite, and that its two render paths
/// agree on tame data.
void RunTetrahedra(FuzzRandom& random, std::string& text, reference::Check& check);

/// Checks that images of vtkShadowedSliceMapper are finite with random lights, cameras, cropping
/// and clipping planes.
void RunShadows(FuzzRandom& random, std::string& text, reference::Check& check);

struct Family
{
  std::string Name;
  void (*Run)(FuzzRandom&, std::string&, reference::Check&);
};

const std::vector<Family>& GetFamilies();

}

#endif
