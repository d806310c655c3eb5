# SPDX-License-Identifier: BSD-3-Clause
# Builds the website. Needs common.sh.

website_packages=(
  python3-sphinx python3-myst-parser furo python3-breathe python3-pil doxygen graphviz libjs-mathjax)
mathjax_dir=/usr/share/javascript/mathjax

# check_website_packages: prints an error message if a package is missing; otherwise prints nothing.
check_website_packages()
{
  { /usr/bin/python3 -c 'import breathe, furo, myst_parser, PIL, sphinx' && doxygen --version &&
    dot -V && [ -d "$mathjax_dir" ]; } >/dev/null 2>&1 ||
    printf 'the website requires the packages %s\n' "${website_packages[*]}"
}

# build_website PAGES SITE IMAGES PYTHON_PATH: writes the website to the directory SITE, and its
# sources to the directory PAGES. IMAGES has an image for each scene of the gallery. PYTHON_PATH is
# the directory of the package interlume.
build_website()
{
  local pages=$1 site=$2 images=$3 python_path=$4
  rm -rf "$pages" "$site"
  copy_website_sources "$pages"
  cd "$source_dir"
  { cat Documentation/site/Doxyfile; printf 'OUTPUT_DIRECTORY = "%s"\n' "$pages"; } | doxygen -
  # Debian's Python has the packages, also if another Python comes first in PATH.
  PYTHONPATH=$python_path PYTHONDONTWRITEBYTECODE=1 \
    /usr/bin/python3 "$pages/Documentation/site/pages.py" "$pages" "$images"
  /usr/bin/python3 -m sphinx -q -W --keep-going -c "$pages/Documentation/site" -d "$pages/.doctrees" \
    "$pages" "$site"
}

# Copies the documents and the files to which they link, and MathJax without its fonts.
copy_website_sources()
{
  local pages=$1
  mkdir -p "$pages/Data" "$pages/extra/Documentation" "$pages/static/mathjax"
  cd "$source_dir"
  find . -maxdepth 1 -type f -exec cp -a {} "$pages" \;
  cp -a Documentation Examples Filters Plugin Python Rendering Testing Utilities "$pages"
  cp -a Data/MANIFEST.md Data/Baseline "$pages/Data"
  cp Documentation/site/index.in.md "$pages/index.md"
  # HTML tags in documents refer to images by their path.
  cp -a Documentation/pictures "$pages/extra/Documentation"
  cd "$mathjax_dir"
  cp -L -r --parents MathJax.js extensions jax/element jax/input/TeX jax/output/SVG/*.js \
    jax/output/SVG/autoload jax/output/SVG/fonts/TeX "$pages/static/mathjax"
}
