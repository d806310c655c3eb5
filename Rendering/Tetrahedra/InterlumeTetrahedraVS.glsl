// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
//INTERLUME::FEATURES

// Each vertex represents a tetrahedron. The vertices are in drawing order.
#ifdef ORDERED
uniform usamplerBuffer order;
#endif
flat out int vertexTetrahedron;

void main()
{
  vertexTetrahedron = gl_VertexID;
#ifdef ORDERED
  vertexTetrahedron = int(texelFetch(order, gl_VertexID).x);
#endif
  gl_Position = vec4(0.0, 0.0, 0.0, 1.0);
}
