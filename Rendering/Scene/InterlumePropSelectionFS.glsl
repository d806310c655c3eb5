// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec

// Draws one color where the image of the prop is not transparent.
in vec2 texCoord;
uniform sampler2D image;
uniform vec3 selectionColor;

//VTK::Output::Dec

void main()
{
  if (!(texture(image, texCoord).a > 0.0))
  {
    discard;
  }
  gl_FragData[0] = vec4(selectionColor, 1.0);
}
