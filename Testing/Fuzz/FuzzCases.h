// SPDX-License-Identifier: BSD-3-Clause
#ifndef FuzzCases_h
#define FuzzCases_h

#include "FuzzRandom.h" // for choices

#include "Support/Checks/ReferenceCheck.h" // for the result

#include <string> // for names
#include <vector> // for the list

/**
 * Families of cases: each makes data and a pipeline of its classes from the numbers it is given,
 * and expects what has to hold. They add what they have chosen to the text.
 */
namespace fuzz
{

/// vtkIntervalVolume with criteria, boundaries and origins; volumes of parts add up on tame data,
/// and changes leave no trace.
void RunIntervals(FuzzRandom& random, std::string& text, reference::Check& check);

/// vtkIsotableContour: points lie on the isovalue.
void RunContours(FuzzRandom& random, std::string& text, reference::Check& check);

/// vtkTimeVaryingIntervalVolume and vtkSimplexTimeSlice over steps of one grid.
void RunTime(FuzzRandom& random, std::string& text, reference::Check& check);

/// vtkImplicitFlowField, vtkInflowMapping and vtkFlowVolume: states are known ones, times within
/// bounds.
void RunFlow(FuzzRandom& random, std::string& text, reference::Check& check);

/// Grids whose arrays contradict each other: a message that names the cell or array, and nothing
/// else.
void RunDamage(FuzzRandom& random, std::string& text, reference::Check& check);

/// Damaged checkpoints and slabs are refused with a word, and give the output that there is
/// without.
void RunFiles(FuzzRandom& random, std::string& text, reference::Check& check);

/// vtkTimeWeightedTetrahedraMapper: pictures of both paths agree on tame data and are finite on
/// all.
void RunTetrahedra(FuzzRandom& random, std::string& text, reference::Check& check);

/// vtkShadowedSliceMapper with lights, soft or hard, in a scene or alone: finite, no more than what
/// the lights give.
void RunShadows(FuzzRandom& random, std::string& text, reference::Check& check);

struct Family
{
  std::string Name;
  void (*Run)(FuzzRandom&, std::string&, reference::Check&);
};

const std::vector<Family>& GetFamilies();

}

#endif
