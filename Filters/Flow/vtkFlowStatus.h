// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkFlowStatus_h
#define vtkFlowStatus_h

#include "vtkDeprecation.h"      // for VTK_DEPRECATION
#include "InterlumeFlowModule.h" // for the export macro

/**
 * @class   vtkFlowStatus
 * @brief   status values and array names of an implicit flow field
 *
 * Check the status before reading any other array. The other arrays are meaningful only for
 * REACHED_SURFACE, except AdvectionTime, which is the time until the end of the streamline for any
 * status.
 */
class INTERLUMEFLOW_EXPORT vtkFlowStatus
{
public:
  enum Values
  {
    /// The streamline reached a termination surface, started on one (time 0), or ended at the
    /// boundary of the field within a tolerance of a surface.
    REACHED_SURFACE = 0,
    /// The streamline left the domain of the field, or reached a blanked cell.
    LEFT_DOMAIN = 1,
    /// The speed fell below the minimum.
    STAGNATED = 2,
    /// The streamline reached the maximum time.
    OUT_OF_TIME = 3,
    /// The streamline reached the maximum number of steps.
    OUT_OF_STEPS = 4,
    /// The sample is outside the domain of the field.
    OUTSIDE = 5,
    /// The field is not finite at the sample or on its streamline.
    NOT_FINITE = 6,
    /// The streamline is a closed orbit and would never end.
    CLOSED_ORBIT = 7,
    NUMBER_OF_VALUES = 8
  };

  /// Return the name of a status in lower case, such as "reached surface", or null for an invalid
  /// value.
  static const char* GetName(int status);

  ///@{
  /**
   * Names of the point arrays: FlowStatus (unsigned char), TerminationId (int; -1 if no surface was
   * reached), TerminationUV (double, 2 components; 0 if no surface was reached), AdvectionTime
   * (double).
   */
  static const char* StatusArray() { return "FlowStatus"; }
  static const char* IdArray() { return "TerminationId"; }
  static const char* ParametersArray() { return "TerminationUV"; }
  static const char* TimeArray() { return "AdvectionTime"; }
  ///@}

  /// Absolute values of TerminationSide. TOWARD: from the sample, in the direction of advection,
  /// the streamline approaches the surface. AWAY: it recedes from the surface or is parallel to it.
  enum TerminationDirections
  {
    TOWARD = 1,
    TOWARDS = TOWARD, ///< deprecated name
    AWAY = 2
  };
  /**
   * Name of the point array TerminationSide (signed char). Its sign is the side of the termination
   * surface on which the sample lies, that is, the sign of the surface's distance. Its absolute
   * value is one of TerminationDirections. It is set for samples that reached a surface and are
   * corners of a cell that this surface crosses. It is 0 for all other samples, for samples past
   * the boundary edge of the surface or on the surface, and for domain faces. If several surfaces
   * have the same id, the nearest one counts.
   */
  static const char* SideArray() { return "TerminationSide"; }

  /**
   * Name of the field array TerminationSurfaces (int, 3 components), with one tuple per id in use:
   * the id, and a flag each for u and v, which is 1 if the parameter is periodic with period 1,
   * otherwise 0.
   */
  static const char* SurfacesArray() { return "TerminationSurfaces"; }
  ///@{
  /**
   * Names of the field arrays with the interpolation error between samples
   * (vtkImplicitFlowField::SetSamplingChecks). SamplingChecks (vtkIdType, one tuple): the number of
   * checked cells (Checks), of cells whose corners differ in their results (SplitCells), of cells
   * whose center differs from most corners in its result (DifferentMiddles), and of cells with a
   * measured error (Compared). SamplingErrors (double, three tuples: mean, 99th percentile,
   * largest): the errors of u, v and time.
   */
  static const char* SamplingChecksArray() { return "SamplingChecks"; }
  static const char* SamplingErrorsArray() { return "SamplingErrors"; }
  ///@}

  /**
   * Prefix of the field arrays with far-side values: the values that a sample near a termination
   * surface would have if the values of the far side extended to it. vtkFlowVolume uses them to cut
   * cells. There is one tuple for each sample at a corner of a cell that a surface crosses and that
   * can be cut there.
   * - BeyondSampleId (vtkIdType): the point id of the sample.
   * - BeyondSamplePosition (double, 3 components): its position. Readers compare it with the point
   *   to detect that a filter has changed the points, which makes these arrays invalid.
   * - BeyondSampleDistance (double), BeyondSampleNormal (double, 3 components): its distance from
   *   the surface, and the surface normal there.
   * - BeyondSampleSurface (int): index of the surface among the surfaces in use; -1 for samples
   *   that stagnate on it; -2 for samples near the boundary of the reached region (below).
   * - BeyondTerminationSide: like TerminationSide, but also set for samples that reached no
   *   surface, and 0 on the surface.
   * - BeyondTerminationId, BeyondTerminationUV, BeyondAdvectionTime and so on: the far-side values.
   *   The streamline of a TOWARD sample continues through the surface; the id is -1 if it reaches
   *   no surface, or if no sample behind the surface has a result. The streamline of an AWAY sample
   *   is followed back to the surface, and the time is negative.
   *
   * If the field has hidden cells or points, or vectors that are not finite, there are also tuples
   * for the corners of cells of which only some corners reach a surface. A sample may have one
   * tuple of each kind. In tuples of this second kind, the distance is measured from the boundary
   * of the reached region, up to a factor, and the normal is 0 (unknown). The side is TOWARD for
   * samples that reach the surface. For all others it is -AWAY, and their far-side values are
   * extrapolated from the reached region.
   */
  static const char* FarSidePrefix() { return "Beyond"; }
  VTK_DEPRECATION("Use FarSidePrefix.")
  static const char* BeyondPrefix() { return FarSidePrefix(); }
  /// Name of the point array of vtkInflowMapping (double, one component); NaN where there is no
  /// value.
  static const char* InflowArray() { return "Inflow"; }
  /// Name of the field array of vtkInflowMapping (int, 3 components): the id, and a flag each for u
  /// and v, which is 1 if the mapping is continuous across the parameter's seam, otherwise 0.
  static const char* InflowPeriodicArray() { return "InflowPeriodic"; }
};

#endif
