// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec

// One point is one tetrahedron; its number is the index that was drawn.
flat out int vertexTetrahedron;

void main()
{
  vertexTetrahedron = gl_VertexID;
  gl_Position = vec4(0.0, 0.0, 0.0, 1.0);
}
