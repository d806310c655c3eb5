// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
//INTERLUME::FEATURES

// Four vertices are one tetrahedron, in the order of drawing; each makes the silhouette and takes
// its corner of the strip. No geometry shader is needed.
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
  // The fourth corner of a triangle is its third once more.
  setHalf(size, corner == 3);
  setOutputs(strip[corner]);
}
