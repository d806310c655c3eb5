// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
//INTERLUME::FEATURES

// Computes the fraction of a light that surfaces of the scene transmit to each cell of a grid,
// averaged over eight positions in the cell. There is one pixel per cell.
uniform mat4 unitFromCell;
// Number of cells along x and y, and number of columns and rows of the texture.
uniform vec4 cellColumns;
// VTK's quad helper reports an error if the shader does not use this.
in vec2 texCoord;

//VTK::Output::Dec
//INTERLUME::OCCLUDERS

void main()
{
  ivec2 texel = ivec2(texCoord * cellColumns.zw);
  int index = texel.x + int(cellColumns.z) * texel.y;
  ivec2 columns = ivec2(cellColumns.xy);
  vec3 cell = vec3(index % columns.x, index / columns.x % columns.y, index / (columns.x * columns.y));
  vec3 sum = vec3(0.0);
  for (int i = 0; i < 8; ++i)
  {
    vec3 place = (unitFromCell * vec4(cell + 0.25 + 0.5 * vec3(i & 1, i >> 1 & 1, i >> 2), 1.0)).xyz;
    sum += vec3(INTERLUME_FRACTION);
  }
  gl_FragData[0] = vec4(0.125 * sum, 1.0);
}
