// What is painted at a place of a surface: red, green, blue, each times alpha, and alpha, the
// opacity in one unit distance.

uniform vec4 defaultColor;
#ifdef DETAIL
uniform vec3 detailScale;
#endif
#if defined(DETAIL) && DETAIL == 3
uniform sampler3D detail;
uniform vec3 detailSize;
#endif
#if defined(DETAIL) && DETAIL == 2
uniform sampler2D detail;
uniform vec3 detailSize;
#endif
#ifdef TIMES
uniform float timePeriod;
uniform float timePhase;
#endif
#ifdef GATE
uniform sampler2D gate;
// The first coordinate of the gate's function and its length.
uniform vec2 gateRange;
#endif
#ifdef TRANSFER
uniform sampler3D opacityValues;
uniform sampler2D transfer;
uniform vec2 transferRange;
#endif
#ifdef PAINT_FILTER
uniform vec2 paintSize;
uniform int largestPieces;
#endif

// From the first texel's middle to the last one's, as an image's points are: the way between these
// and the first one's place, in the texture.
vec2 inTexture(vec2 place, vec4 frame)
{
  return clamp(place, 0.0, 1.0) * frame.xy + frame.zw;
}

//INTERLUME::PAINTS

#ifdef PAINT_FILTER
// The axes of what a sample stands for: the piece of the ray, and a pixel at that distance.
struct Footprint
{
  vec3 Piece;
  vec3 PixelX;
  vec3 PixelY;
};

// Returns the length of the longest axis, in voxels.
float reachOf(Footprint footprint)
{
  return sqrt(max(dot(footprint.Piece, footprint.Piece),
    max(dot(footprint.PixelX, footprint.PixelX), dot(footprint.PixelY, footprint.PixelY))));
}

// Returns whether a sample may be larger than two texels, which a look at one place covers, by the
// code of a bound of the slopes in its cell.
bool isWide(int code, Footprint footprint)
{
  return reachOf(footprint) * max(paintSize.x, paintSize.y) >
    2.0 * exp2(128.0 - float(code) / 256.0);
}

// Splits what a sample stands for, by its three axes, into the longest and what is across it.
void setFootprint(inout Sample found, Footprint footprint)
{
  vec2 along = found.Slope * footprint.Piece;
  vec2 x = found.Slope * footprint.PixelX;
  vec2 y = found.Slope * footprint.PixelY;
  vec3 axis = footprint.Piece;
  vec2 across;
  found.IsAlongRay = true;
  float a = dot(along, along);
  float b = dot(x, x);
  float c = dot(y, y);
  // What is along the ray is drawn piece by piece; across it there is a mean.
  if (b > a && b >= c)
  {
    axis = footprint.PixelX;
    found.IsAlongRay = false;
    across = a > c ? along : y;
    found.Along = x;
  }
  else if (c > a)
  {
    axis = footprint.PixelY;
    found.IsAlongRay = false;
    across = a > b ? along : x;
    found.Along = y;
  }
  else
  {
    across = b > c ? x : y;
    found.Along = along;
  }
  found.TimeAlong = dot(found.TimeSlope, axis);
  vec2 texels = abs(found.Along) * paintSize;
  found.Pieces = clamp(int(ceil(max(texels.x, texels.y))), 1, largestPieces);
  found.Size = max(abs(across), abs(found.Along) / float(found.Pieces));
}

float levelOf(vec2 texels)
{
  return log2(max(max(texels.x, texels.y), 1.0));
}
#endif

// Returns -log(1 - alpha), with all digits of small ones too, and 69 at most.
float depthOf(float alpha)
{
  return alpha < 0.05 ? alpha * (1.0 + alpha * (1.0 / 2.0 + alpha * (1.0 / 3.0 + alpha / 4.0)))
                      : -log(max(1.0 - alpha, 1e-30));
}

float strengthAt(vec3 place)
{
#ifdef TRANSFER
  float value = texture(opacityValues, (place + 0.5) * voxelSize).r;
  float column = clamp((value - transferRange.x) * transferRange.y, 0.0, 1.0);
  float size = float(TRANSFER);
  return texture(transfer, vec2((column * (size - 1.0) + 0.5) / size, 0.5)).r;
#else
  return 1.0;
#endif
}

#ifdef GATE
float gateAt(float injected)
{
#ifdef GATE_REPEATS
  float column = fract(injected);
#else
  float column = clamp((injected - gateRange.x) / gateRange.y, 0.0, 1.0);
#endif
  float size = float(GATE);
  return texture(gate, vec2((column * (size - 1.0) + 0.5) / size, 0.5)).r;
}
#endif

// Returns what is painted in the part of the sample at a share of its longest axis, -0.5 to 0.5.
vec4 paintOf(Sample found, float share)
{
  vec2 place = found.Place;
  float level = 0.0;
#ifdef PAINT_FILTER
  if (found.IsWide)
  {
    place += share * found.Along;
    level = levelOf(found.Size * paintSize);
  }
#endif
  vec2 inside = place - mix(vec2(0.0), floor(place), vec2(found.Period));
  vec4 paint = inflowAt(found.Paint, inside, level);
#ifdef TIMES
  float time = found.Time;
#ifdef PAINT_FILTER
  time += found.IsWide ? share * found.TimeAlong : 0.0;
#endif
  // The time at which paint was put in here, in periods.
  float injected = timePhase - time / timePeriod;
#endif
#ifdef GATE
  float open = gateAt(injected);
#ifdef GATE_INFLOW
  paint *= open;
#endif
#endif
#ifdef DETAIL
  vec2 pattern = inside * detailScale.xy;
#ifdef PAINT_FILTER
  level = found.IsWide ? levelOf(found.Size * abs(detailSize.xy * detailScale.xy)) : 0.0;
#endif
#if DETAIL == 3
  vec4 fine = textureLod(detail, vec3(pattern, -injected * timePeriod * detailScale.z), level);
#else
  vec4 fine = textureLod(detail, pattern, level);
#endif
#if defined(GATE_DETAIL) && defined(DETAIL_MODULATE)
  fine = mix(vec4(1.0), fine, open);
#elif defined(GATE_DETAIL)
  fine *= open;
#endif
#if defined(DETAIL_OVER)
  paint = fine + (1.0 - fine.a) * paint;
#elif defined(DETAIL_ADD)
  paint = min(paint + fine, 1.0);
#else
  paint *= fine;
#endif
#endif
  return paint;
}

// Returns the number of parts of a sample that are drawn one behind the other.
int partsOf(Sample found)
{
#ifdef PAINT_FILTER
  return found.IsAlongRay ? found.Pieces : 1;
#else
  return 1;
#endif
}

// Looks a piece up. Returns whether there is paint to draw: that of each piece along the ray, and the
// mean of all across it after the last.
bool takePiece(Sample found, int piece, inout vec4 sum, out vec4 paint)
{
#ifdef PAINT_FILTER
  sum += paintOf(found, (float(piece) + 0.5) / float(found.Pieces) - 0.5);
  if (!found.IsAlongRay)
  {
    paint = sum / float(found.Pieces);
    return piece == found.Pieces - 1;
  }
  paint = sum;
  sum = vec4(0.0);
#else
  paint = paintOf(found, 0.0);
#endif
  return true;
}
