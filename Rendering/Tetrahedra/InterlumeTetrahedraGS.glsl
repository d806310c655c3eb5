// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
//INTERLUME::FEATURES

// Each input point represents a tetrahedron.
layout(points) in;
layout(triangle_strip, max_vertices = 4) out;

flat in int vertexTetrahedron[];

//INTERLUME::SILHOUETTE

void main()
{
  int size = makeSilhouette(vertexTetrahedron[0]);
  if (size == 0)
  {
    return;
  }
  setHalf(size, false);
  for (int i = 0; i < size; ++i)
  {
    if (i == 3)
    {
      setHalf(size, true);
    }
    setOutputs(strip[i]);
    EmitVertex();
  }
  EndPrimitive();
}
