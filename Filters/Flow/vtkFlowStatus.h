#ifndef vtkFlowStatus_h
#define vtkFlowStatus_h

#include "InterlumeFlowModule.h" // for the export macro

/**
 * @class   vtkFlowStatus
 * @brief   how the advection of a sample ended, and the names of the arrays that say so
 *
 * Everything that reads an implicit flow field asks the status first: the other arrays have a
 * meaning for REACHED_SURFACE only, but for AdvectionTime, which is the time until the end however
 * it came.
 */
class INTERLUMEFLOW_EXPORT vtkFlowStatus
{
public:
  enum Values
  {
    /// It reached a termination surface, or is on one (time 0), or ended at the end of the field
    /// within a tolerance of one.
    REACHED_SURFACE = 0,
    /// It left the field's domain, or came to a blanked cell.
    LEFT_DOMAIN = 1,
    /// Its speed fell below the minimum.
    STAGNATED = 2,
    /// It went on for the maximum time.
    OUT_OF_TIME = 3,
    /// It took the maximum number of steps.
    OUT_OF_STEPS = 4,
    /// The sample is not in the field's domain.
    OUTSIDE = 5,
    /// The field is not finite at the sample or where it came.
    NOT_FINITE = 6,
    /// It goes round and round, and would until its steps are used up.
    CLOSED_ORBIT = 7,
    NUMBER_OF_VALUES = 8
  };

  /// In small letters, "reached surface"; null for a number that is none.
  static const char* GetName(int status);

  ///@{
  /**
   * Point arrays: FlowStatus (unsigned char), TerminationId (int, -1 without one), TerminationUV
   * (double, 2 components, 0 without), AdvectionTime (double).
   */
  static const char* StatusArray() { return "FlowStatus"; }
  static const char* IdArray() { return "TerminationId"; }
  static const char* ParametersArray() { return "TerminationUV"; }
  static const char* TimeArray() { return "AdvectionTime"; }
  ///@}

  /// Absolute values in TerminationSide: whether the streamline, in the direction it is followed,
  /// leaves the sample towards the surface, or away from it (or along it).
  enum Ways
  {
    TOWARDS = 1,
    AWAY = 2
  };
  /**
   * Point array TerminationSide (signed char): on which side of the surface of its id a sample
   * lies, above 0 where the surface's distance is, and by Ways how the streamline leaves it. Of
   * samples that reached a surface and are a corner of a cell that this surface passes through; 0
   * for all others, for those beyond a rim of the surface, on it, and for domain faces. Of several
   * surfaces of one id the nearest counts.
   */
  static const char* SideArray() { return "TerminationSide"; }

  /**
   * Field array TerminationSurfaces (int, 3 components), a tuple for each id in use: the id, and
   * whether u and v are periodic with period 1 there.
   */
  static const char* SurfacesArray() { return "TerminationSurfaces"; }
  /**
   * What the names of field arrays begin with that have a tuple for each sample beside a surface
   * that passes through a cell of the samples and can be cut there. BeyondSampleId (vtkIdType):
   * its point. BeyondSamplePosition (double, 3 components): where that is. BeyondSampleDistance
   * (double), BeyondSampleNormal (double, 3 components): from the surface, and its normal there.
   * BeyondSampleSurface (int): the number of the surface among those in use, -1 for samples that
   * stand still on it. BeyondTerminationSide as TerminationSide, but of samples without an answer
   * too, and 0 on the surface. BeyondTerminationId, BeyondTerminationUV, BeyondAdvectionTime and so
   * on: what the sample would have if the answers of the surface's other side went on to it. On the
   * side of TOWARDS that is where the streamline comes to when it goes on through the surface, id
   * -1 where it reaches nothing or where nothing behind has an answer. On the side of AWAY it is
   * where the streamline comes from, with a time below 0. Filters that change points leave them of
   * no use, which is found out by the positions.
   */
  static const char* BeyondPrefix() { return "Beyond"; }
  /// Point array of vtkInflowMapping (double, one component): NaN where there is none.
  static const char* InflowArray() { return "Inflow"; }
  /// Field array of vtkInflowMapping (int, 3 components): an id, and whether its mapping goes on
  /// over the seams of u and v.
  static const char* InflowPeriodicArray() { return "InflowPeriodic"; }
};

#endif
