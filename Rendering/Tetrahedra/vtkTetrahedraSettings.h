// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkTetrahedraSettings_h
#define vtkTetrahedraSettings_h

#include "vtkSmartPointer.h" // for the boundary's looks

#include <map>    // for the priorities
#include <string> // for array names

class vtkProperty;
class vtkTexture;

/**
 * @class   vtkTetrahedraSettings
 * @brief   what vtkTimeWeightedTetrahedraMapper can be told, with its defaults and its modes
 *
 * The mapper is made of them, so that VTK's macros for setters serve them, and hands them on as a
 * whole. Each is documented at its setter there; the blend mode is kept by the mapper's superclass.
 *
 * @sa vtkTimeWeightedTetrahedraMapper
 */
struct vtkTetrahedraSettings
{
  /**
   * How the segments of a line of sight are put together.
   */
  enum BlendModes
  {
    /// Front to back in order of visibility: COMPOSITE_BLEND of the superclass, 0.
    /// The largest scalar's colour and opacity: MAXIMUM_INTENSITY_BLEND of the superclass, 1.
    /// Sum of colour times opacity, without order; saturates.
    ADDITIVE_BLEND = 2,
    /// Each layer on its own (as OPTICAL_DEPTH_BLEND), then the layers by priority, whatever lies
    /// in front.
    PRIORITY_BLEND = 3,
    /// 1 - exp(-sum of optical depth), with the mean of colour weighted by optical depth: needs no
    /// order; exact for one colour.
    OPTICAL_DEPTH_BLEND = 4,
    /// OPTICAL_DEPTH_BLEND with Dt, whose tetrahedra overlap so that no order exists; else
    /// COMPOSITE_BLEND.
    AUTOMATIC_BLEND = 5
  };

  /**
   * How colour and opacity of one segment are found.
   */
  enum IntegrationModes
  {
    /// The mean of colour and of extinction at both ends, as the source has it.
    AVERAGE_COLOR = 0,
    /// The exact integral over linear colour and extinction (K. Moreland, E. Angel, "A fast high
    /// accuracy volume renderer for unstructured data", 2004), from control point to control point.
    LINEAR_SEGMENT = 1
  };

  /**
   * Order of the tetrahedra.
   */
  enum SortModes
  {
    NO_SORT = 0,
    /// Distance of the centroid, from the eye in perspective, along the view in parallel.
    CENTROID_SORT = 1,
    /// Visibility over shared faces (P. Williams, "Visibility-ordering meshed polyhedra", 1992),
    /// with the gaps of a mesh that is not convex closed along lines of sight.
    MPVONC_SORT = 2,
    /// NO_SORT where the blend mode or one colour makes order irrelevant; MPVONC_SORT up to
    /// 1,000,000 tetrahedra without Dt; else CENTROID_SORT.
    AUTOMATIC_SORT = 3
  };

  /**
   * Who draws.
   */
  enum RenderPaths
  {
    /// Silhouettes by shaders and a float framebuffer, OpenGL 3.2 core.
    OPENGL_PATH = 0,
    /// Threads and tiles on the CPU.
    SOFTWARE_PATH = 1,
    /// SOFTWARE_PATH where OpenGL is itself software, else OPENGL_PATH.
    AUTOMATIC_PATH = 2
  };

  /**
   * Which shader makes the silhouettes of tetrahedra with OPENGL_PATH.
   */
  enum SilhouetteShaders
  {
    /// A geometry shader, of one point for each tetrahedron.
    GEOMETRY_SHADER = 0,
    /// A vertex shader, whose four vertices for each tetrahedron pull it from buffers.
    VERTEX_SHADER = 1,
    /// GEOMETRY_SHADER where OpenGL is software, VERTEX_SHADER on a graphics card.
    AUTOMATIC_SHADER = 2
  };

  int IntegrationMode = LINEAR_SEGMENT;
  int SortMode = AUTOMATIC_SORT;
  int RenderPath = AUTOMATIC_PATH;
  int SilhouetteShader = AUTOMATIC_SHADER;
  bool HasDeltaTArrayName = false;
  std::string DeltaTArrayName;
  std::string LayerArrayName = "IntervalId";
  std::map<int, double> LayerPriorities;
  vtkSmartPointer<vtkProperty> BoundaryProperty;
  vtkSmartPointer<vtkTexture> BoundaryTexture;
  bool AutoAdjustLevelOfDetail = true;
};

#endif
