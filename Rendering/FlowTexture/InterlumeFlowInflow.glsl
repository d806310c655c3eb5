
// Looks up a color in an inflow texture. FlowShader inserts a copy of this file for each image, and
// replaces N with the image's name.
uniform sampler2D paint_N;
uniform vec4 paintFrame_N;

vec4 inflowUpTo_N(int paint, vec2 place, float level)
{
  if (paint == NUMBER)
  {
    return textureLod(paint_N, inTexture(place, paintFrame_N), level);
  }
  return inflowUpTo_P(paint, place, level);
}
