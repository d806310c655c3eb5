// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
//INTERLUME::FEATURES

// Composites an image over the scene. Its color is premultiplied by opacity.
in vec2 texCoord;
uniform sampler2D image;
uniform vec2 share;

//VTK::Output::Dec

void main()
{
  vec4 color = texture(image, texCoord * share);
#ifdef SATURATE
  color = min(color, 1.0);
#endif
#ifdef SUM
  color.a = 0.0;
#endif
#ifdef SELECTION
  // The color identifies a cell. The fourth channel is the cell's depth, or negative if there is no
  // cell.
  if (color.a < 0.0)
  {
    discard;
  }
  gl_FragDepth = color.a;
  color.a = 1.0;
#endif
  gl_FragData[0] = color;
}
