# SPDX-License-Identifier: BSD-3-Clause
# Brings ParaView into a folder of its own: its Python package cannot be installed beside VTK's.
# Needs common.sh and packages.sh.

paraview_root=$build_root/paraview-root
paraview_stamp=$paraview_root/.unpacked
# The plugin is built with this ParaView; others come when it knows them.
paraview_wanted=5.11

# Prints why ParaView's plugin cannot be built on this system; nothing where it can.
paraview_obstacle()
{
  local version
  [ ! -e "$paraview_stamp" ] || return 0
  version=$(available_version paraview)
  case $version in
    "$paraview_wanted".*) ;;
    '') printf 'this system has no ParaView; the plugin needs %s' "$paraview_wanted" ;;
    *) printf 'this system has ParaView %s; the plugin needs %s' \
      "${version%%[+-]*}" "$paraview_wanted" ;;
  esac
}

fetch_paraview()
{
  local packages=$build_root/paraview-packages obstacle
  obstacle=$(paraview_obstacle)
  [ -z "$obstacle" ] || die "$obstacle"
  install_packages paraview-build "${paraview_build_packages[@]}"
  if [ ! -e "$paraview_stamp" ]; then
    say "Fetching ParaView into ${paraview_root#"$source_dir"/}"
    rm -rf "$paraview_root" "$packages"
    mkdir -p "$paraview_root" "$packages"
    run_logged fetch-paraview download_packages "$packages" paraview paraview-dev python3-paraview
    run_logged install-paraview-libraries \
      apt_get satisfy "$(libraries_of "$packages"/paraview_*.deb)"
    run_logged unpack-paraview unpack_packages "$packages" "$paraview_root"
    rm -rf "$packages"
    touch "$paraview_stamp"
  fi
}

download_packages()
{
  cd "$1"
  shift
  apt-get -q download "$@" || { as_root apt-get -q update && apt-get -q download "$@"; }
}

# The dependencies of a package without its interpreters: scripts here need only numpy and mpi4py.
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
