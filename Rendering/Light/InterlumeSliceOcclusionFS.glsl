//VTK::System::Dec

// Marks where what comes behind cannot be seen, by a depth that nothing is nearer than.
in vec2 texCoord;
uniform sampler2D picture;
uniform float opaque;

void main()
{
  if (texture(picture, texCoord).a < opaque)
  {
    discard;
  }
  gl_FragDepth = 0.0;
}
