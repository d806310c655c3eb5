# SPDX-License-Identifier: BSD-3-Clause
# Unpacks ParaView into a separate directory, because its Python package conflicts with VTK's. Needs
# common.sh and packages.sh.

paraview_root=$build_root/paraview-root
paraview_stamp=$paraview_root/.unpacked
paraview_known='5.11 5.13 6.1'

# Prints the version of ParaView for which the plugin is built: the unpacked one, or else the
# available package.
paraview_version()
{
  if [ -s "$paraview_stamp" ]; then
    cat "$paraview_stamp"
  else
    available_version paraview
  fi
}

# Prints an error message if the plugin cannot be built on this system; otherwise prints nothing.
check_paraview()
{
  local version known
  version=$(paraview_version)
  for known in $paraview_known; do
    case $version in "$known".*) return ;; esac
  done
  if [ -n "$version" ]; then
    printf 'this system has ParaView %s' "${version%%[+-]*}"
  else
    printf 'this system has no package of ParaView'
  fi
  printf '; the plugin supports %s' "${paraview_known// /, }"
}

fetch_paraview()
{
  local packages=$build_root/paraview-packages error version client_packages
  error=$(check_paraview)
  [ -z "$error" ] || die "$error"
  version=$(paraview_version)
  case $version in
    5.11.*) client_packages=("${paraview_qt5_packages[@]}") ;;
    5.13.*) client_packages=("${paraview_qt6_packages[@]}") ;;
    *) client_packages=("${paraview_qt6_packages[@]}" "${paraview_6_packages[@]}") ;;
  esac
  install_packages paraview-build "${paraview_build_packages[@]}" "${client_packages[@]}"
  if [ ! -s "$paraview_stamp" ]; then
    say "Fetching ParaView into ${paraview_root#"$source_dir"/}"
    rm -rf "$paraview_root" "$packages"
    mkdir -p "$paraview_root" "$packages"
    run_logged fetch-paraview download_packages "$packages" paraview paraview-dev python3-paraview
    run_logged install-paraview-libraries \
      apt_get satisfy "$(libraries_of "$packages"/paraview_*.deb)"
    run_logged unpack-paraview unpack_packages "$packages" "$paraview_root"
    link_python_modules "$paraview_root"
    rm -rf "$packages"
    printf '%s\n' "$version" >"$paraview_stamp"
  fi
}

download_packages()
{
  cd "$1"
  shift
  apt-get -q download "$@" || { as_root apt-get -q update && apt-get -q download "$@"; }
}

# Prints the dependencies of a package except tclsh and Python packages. Of these, the scripts need
# only numpy and mpi4py.
libraries_of()
{
  dpkg-deb -f "$1" Depends | sed -E 's/(^|, )(tclsh|python3-[^,]*)//g; s/^, //'
}

unpack_packages()
{
  local package
  for package in "$1"/*.deb; do
    dpkg -x "$package" "$2"
  done
}

# Adds links without the interpreter's tag to the names of Python modules, since ParaView's CMake
# package refers to these names.
link_python_modules()
{
  local module plain
  find "$1/usr/lib/python3" -name '*.cpython-*.so' | while read -r module; do
    plain=${module%%.cpython-*}.so
    [ -e "$plain" ] || ln -s "${module##*/}" "$plain"
  done
}
