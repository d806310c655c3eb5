#ifndef vtkTetrahedraExtent_h
#define vtkTetrahedraExtent_h

struct vtkTetrahedraMesh;

/**
 * How far a mesh reaches.
 */
namespace vtkTetrahedraExtent
{
/// The greatest distance of a point from the origin of the mesh's coordinates; 0 without points.
double GetRadius(const vtkTetrahedraMesh& mesh);
}

#endif
