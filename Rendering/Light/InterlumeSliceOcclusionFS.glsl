//VTK::System::Dec
//INTERLUME::FEATURES

// Marks where what comes behind cannot be seen, by a depth that nothing is nearer than.
in vec2 texCoord;
uniform sampler2D slices;

void main()
{
  // Too little to be seen.
  const float least = 1e-5;
  vec4 texel = texture(slices, texCoord);
#ifdef TRANSMITTANCE
  bool isOpaque = max(max(texel.r, texel.g), texel.b) < least;
#else
  bool isOpaque = texel.a > 1.0 - least;
#endif
  if (!isOpaque)
  {
    discard;
  }
  gl_FragDepth = 0.0;
}
