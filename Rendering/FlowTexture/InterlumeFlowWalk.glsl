// Walks a line of sight, sample by sample. A sample stands for the piece of the ray around it; the
// last one is shorter.

struct Ray
{
  vec3 Origin;
  vec3 Way;
  // The length of the ray's direction, in world units.
  float Unit;
  float Lower;
  float Upper;
  // Where the next sample's piece begins, and the number of samples before it.
  float From;
  float Number;
};

bool goesOn(Ray ray, vec4 sum)
{
  return ray.From < ray.Upper && sum.a < OPAQUE_ENOUGH;
}

float pieceOf(Ray ray)
{
  return min(sampleDistance, ray.Upper - ray.From);
}

vec3 placeOf(Ray ray)
{
  return ray.Origin + (ray.From + 0.5 * pieceOf(ray)) * ray.Way;
}

vec3 cellOf(vec3 place)
{
  return clamp(floor(place), vec3(0.0), lastCell);
}

void pass(inout Ray ray, float samples)
{
  ray.Number += samples;
  ray.From = ray.Lower + ray.Number * sampleDistance;
}

// Adds what is painted at a place.
void add(Ray ray, Sample found, vec3 place, inout vec4 sum)
{
  float to = 0.5 * pieceOf(ray);
  float from = -to;
  cutToRegions(place, ray.Way, from, to);
  float depth = (to - from) * unitShare / float(partsOf(found));
  float strength = to > from ? strengthAt(place) : 0.0;
#ifdef SHADE
  Light light = lightAt(place, ray.Way);
#endif
#ifdef PAINT_FILTER
  int pieces = found.Pieces;
#else
  const int pieces = 1;
#endif
  vec4 pending = vec4(0.0);
  for (int i = 0; i < pieces && strength > 0.0; ++i)
  {
    vec4 paint;
    if (takePiece(found, i, pending, paint))
    {
      paint *= strength;
      float opacity = opacityOf(paint.a, depth);
      vec3 color = paint.rgb * (opacity / max(paint.a, 1e-30));
#ifdef SHADE
      color = color * light.Diffuse + opacity * light.Specular;
#endif
      sum += (1.0 - sum.a) * vec4(color, opacity);
    }
  }
}

#ifdef PAINT_FILTER
Footprint footprintOf(Ray ray, float from, float piece)
{
  float share = (from + 0.5 * piece) / ray.Unit;
  return Footprint(ray.Way * piece, (rayOriginX + share * rayDirectionX) * pixelSize.x,
    (rayOriginY + share * rayDirectionY) * pixelSize.y);
}

// How far what a sample stands for may reach, in voxels; between two ways it is never further.
float reachOf(Ray ray, float from)
{
  return reachOf(footprintOf(ray, from - 0.5 * sampleDistance, sampleDistance));
}
#endif

// Adds what is painted at a place of one cell, of the size that the sample stands for. Returns
// whether the sample may be larger than two texels.
bool addSized(Ray ray, Sample found, int code, vec3 place, inout vec4 sum)
{
#ifdef PAINT_FILTER
  Footprint footprint = footprintOf(ray, ray.From, pieceOf(ray));
  found.IsWide = isWide(code, footprint);
  if (found.IsWide)
  {
    setFootprint(found, footprint);
  }
#endif
  add(ray, found, place, sum);
#ifdef PAINT_FILTER
  return found.IsWide;
#else
  return false;
#endif
}

#ifdef SMOOTH_PLACES
// Software executes both sides of each branch, and each loop once at least, so what few samples need
// has a loop of its own, around those of what most need.

// Walks while samples have nothing, or one surface and no more than two texels.
void walkSmooth(inout Ray ray, float reach, float stride, inout vec4 sum)
{
  while (true)
  {
    vec3 place = placeOf(ray);
    vec4 stored = storedAt(place);
    bool isOver = !goesOn(ray, sum);
#if defined(SPLITS) || defined(SEAMS)
    isOver = isOver || stored.a > LARGEST_LABEL;
#endif
#ifdef PAINT_FILTER
    isOver = isOver || stored.b * reach > 2.0;
#endif
    if (isOver)
    {
      break;
    }
#ifdef EMPTY_CELLS
    if (stored.a > 0.0)
#endif
    {
      Sample found = noSample();
      setSurface(found, int(stored.a));
      lookUpPlace(place, stored, found);
      add(ray, found, place, sum);
    }
#ifdef EMPTY_CELLS
    // The distance from a place is at most 1 less than that from its cell.
    pass(ray, max(floor((-1.0 - stored.a) * stride), 1.0));
#else
    pass(ray, 1.0);
#endif
  }
}

#ifdef PLAIN_CELLS
// Walks on in cells of one surface, while samples may have more than two texels or something else is
// in a cell around. Returns whether a split cell is next.
bool walkPlain(inout Ray ray, inout vec4 sum)
{
  bool isOver = false;
  bool isBeforeSplit = false;
  while (!isOver && goesOn(ray, sum))
  {
    vec3 place = placeOf(ray);
    vec3 cell = cellOf(place);
    ivec2 stored = kindAt(ivec3(cell));
#ifdef SPLITS
    if (isSplit(stored.x))
    {
      isBeforeSplit = true;
      break;
    }
#endif
    bool isSeam = stored.x > SEAM;
    Sample found = noSample();
    setSurface(found, isSeam ? stored.x - SEAM : stored.x);
    lookUpPlain(ivec3(cell), place - cell, isSeam, found);
    if (stored.x < EMPTY)
    {
      isOver = !addSized(ray, found, stored.y, place, sum) && (stored.y & 1) == 1;
    }
    else
    {
      isOver = stored.x > EMPTY + 1;
    }
    pass(ray, 1.0);
  }
  return isBeforeSplit;
}
#endif

#ifdef SPLITS
void walkSplits(inout Ray ray, inout vec4 sum)
{
  while (goesOn(ray, sum))
  {
    vec3 place = placeOf(ray);
    vec3 cell = cellOf(place);
    ivec2 stored = kindAt(ivec3(cell));
    if (!isSplit(stored.x))
    {
      break;
    }
    Sample found = noSample();
    if (lookUpSplit(ivec3(cell), place - cell, stored.x == SPLIT_BY_WAYS, found))
    {
      addSized(ray, found, stored.y, place, sum);
    }
    pass(ray, 1.0);
  }
}
#endif
#else
// Walks through cells of all kinds.
void walkCells(inout Ray ray, vec3 inverse, inout vec4 sum)
{
  while (goesOn(ray, sum))
  {
    vec3 place = placeOf(ray);
    vec3 cell = cellOf(place);
    ivec2 stored = kindAt(ivec3(cell));
    float samples = 1.0;
    if (stored.x >= EMPTY)
    {
      // All cells nearer than the distance are empty: the samples there are passed over.
      float distance = float(stored.x - EMPTY);
      vec3 ends = mix(cell + 1.0 - distance, cell + distance, greaterThan(ray.Way, vec3(0.0)));
      vec3 exits = (ends - place) * inverse;
      samples += max(ceil(min(min(exits.x, exits.y), exits.z) / sampleDistance) - 1.0, 0.0);
    }
    else
    {
      Sample found = noSample();
      if (lookUpCell(place, cell, stored.x, true, found))
      {
        addSized(ray, found, stored.y, place, sum);
      }
    }
    pass(ray, samples);
  }
}
#endif
