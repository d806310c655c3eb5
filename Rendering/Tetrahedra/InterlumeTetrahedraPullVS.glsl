// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
//INTERLUME::FEATURES

// Each group of four vertices represents a tetrahedron. The groups are in drawing order. Each
// vertex computes the whole silhouette but outputs only one corner of it, so no geometry shader is
// needed.
#ifdef ORDERED
uniform usamplerBuffer order;
#endif

//INTERLUME::SILHOUETTE

void main()
{
  int tetrahedron = gl_VertexID >> 2;
  int corner = gl_VertexID & 3;
#ifdef ORDERED
  tetrahedron = int(texelFetch(order, tetrahedron).x);
#endif
  int size = makeSilhouette(tetrahedron);
  if (size == 0)
  {
    setOutputs(vec2(-viewport));
    return;
  }
  // If the silhouette is a triangle, its third corner is output twice.
  setHalf(size, corner == 3);
  setOutputs(strip[corner]);
}
