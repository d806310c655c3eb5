// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkFlowStatus_h
#define vtkFlowStatus_h

#include "InterlumeFlowModule.h" // for the export macro

/**
 * @class   vtkFlowStatus
 * @brief   how the advection of a sample ended, and the names of the arrays that say so
 *
 * Every reader of an implicit flow field asks the status first: the other arrays have a meaning for
 * REACHED_SURFACE only, but for AdvectionTime, which is the time until the end however it came.
 */
class INTERLUMEFLOW_EXPORT vtkFlowStatus
{
public:
  enum Values
  {
    /// The streamline reached a termination surface, or is on one (time 0), or ended at the end of
    /// the field within a tolerance of one.
    REACHED_SURFACE = 0,
    /// The streamline left the field's domain, or came to a blanked cell.
    LEFT_DOMAIN = 1,
    /// The streamline's speed fell below the minimum.
    STAGNATED = 2,
    /// The streamline went on for the maximum time.
    OUT_OF_TIME = 3,
    /// The streamline took the maximum number of steps.
    OUT_OF_STEPS = 4,
    /// The sample is not in the field's domain.
    OUTSIDE = 5,
    /// The field is not finite at the sample or where its streamline came.
    NOT_FINITE = 6,
    /// The streamline is a closed orbit, which it would follow until its steps are used up.
    CLOSED_ORBIT = 7,
    NUMBER_OF_VALUES = 8
  };

  /// Returns the name of a status in small letters, such as "reached surface"; null for a number
  /// that is not a status.
  static const char* GetName(int status);

  ///@{
  /**
   * The names of the point arrays: FlowStatus (unsigned char), TerminationId (int, -1 without one),
   * TerminationUV (double, 2 components, 0 without), AdvectionTime (double).
   */
  static const char* StatusArray() { return "FlowStatus"; }
  static const char* IdArray() { return "TerminationId"; }
  static const char* ParametersArray() { return "TerminationUV"; }
  static const char* TimeArray() { return "AdvectionTime"; }
  ///@}

  /// The absolute values in TerminationSide, which tell whether the streamline, in the direction it
  /// is followed, leaves the sample towards the surface, or away from it (or along it).
  enum Ways
  {
    TOWARDS = 1,
    AWAY = 2
  };
  /**
   * The name of the point array TerminationSide (signed char), which tells on which side of the
   * surface of its id a sample lies, above 0 where the surface's distance is, and by Ways how the
   * streamline leaves the sample. It is set for samples that reached a surface and are a corner of
   * a cell that this surface passes through; it is 0 for all others, for those beyond a rim of the
   * surface or on it, and for domain faces. Where several surfaces have one id, the nearest counts.
   */
  static const char* SideArray() { return "TerminationSide"; }

  /**
   * The name of the field array TerminationSurfaces (int, 3 components), which has a tuple for each
   * id in use: the id, and whether u and v are periodic with period 1 there.
   */
  static const char* SurfacesArray() { return "TerminationSurfaces"; }
  ///@{
  /**
   * The names of the field arrays of samples in whose cells interpolation was compared with
   * streamlines (vtkImplicitFlowField::SetSamplingChecks). SamplingChecks (vtkIdType, one tuple):
   * Checks, SplitCells, DifferentMiddles, Compared. SamplingErrors (double, three tuples: mean, 99
   * in 100, largest): the errors of u, v and time.
   */
  static const char* SamplingChecksArray() { return "SamplingChecks"; }
  static const char* SamplingErrorsArray() { return "SamplingErrors"; }
  ///@}

  /**
   * The beginning of the names of field arrays that have a tuple for each sample beside a surface,
   * where that passes through a cell of the samples which can be cut there. BeyondSampleId
   * (vtkIdType): the point of the sample. BeyondSamplePosition (double, 3 components): the position
   * of that point. BeyondSampleDistance (double), BeyondSampleNormal (double, 3 components): its
   * distance from the surface, and the surface's normal there. BeyondSampleSurface (int): the
   * number of the surface among those in use, -1 for samples that stand still on it, -2 for samples
   * beside the boundary of what reaches a surface (below).
   * BeyondTerminationSide: as TerminationSide, but for samples without an answer too, and 0 on the
   * surface. BeyondTerminationId, BeyondTerminationUV, BeyondAdvectionTime and so on: what the
   * sample would have if the answers of the surface's other side went on to it. For a sample of
   * TOWARDS that is where the streamline comes to when it goes on through the surface, id -1 where
   * it reaches nothing or where nothing behind has an answer. For a sample of AWAY it is where the
   * streamline comes from, with a time below 0. A filter that changes points makes these arrays
   * useless, which readers find out by the positions.
   *
   * If the field has hidden cells or points, or vectors that are not finite, there are such tuples
   * too for the corners of cells only some of which reach a surface; a sample may have one of each.
   * Their distances are from the boundary of what reaches it, up to a factor; the normal is 0 and
   * not known. The side is TOWARDS for samples that reach the surface, and -AWAY for others, whose
   * other arrays have values that are extrapolated from what reaches it.
   */
  static const char* BeyondPrefix() { return "Beyond"; }
  /// The name of the point array of vtkInflowMapping (double, one component), NaN where there is no
  /// value.
  static const char* InflowArray() { return "Inflow"; }
  /// The name of the field array of vtkInflowMapping (int, 3 components): an id, and whether its
  /// mapping goes on over the seams of u and v.
  static const char* InflowPeriodicArray() { return "InflowPeriodic"; }
};

#endif
