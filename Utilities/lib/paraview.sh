# Brings ParaView into a folder of its own: its Python package cannot be installed beside VTK's.
# Needs common.sh and packages.sh.

paraview_root=$build_root/paraview-root

fetch_paraview()
{
  local stamp=$paraview_root/.unpacked packages=$build_root/paraview-packages
  install_packages paraview-build "${paraview_build_packages[@]}"
  if [ ! -e "$stamp" ]; then
    say "Fetching ParaView into ${paraview_root#"$source_dir"/}"
    rm -rf "$paraview_root" "$packages"
    mkdir -p "$paraview_root" "$packages"
    run_logged fetch-paraview download_packages "$packages" paraview paraview-dev python3-paraview
    run_logged install-paraview-libraries \
      apt_get satisfy "$(libraries_of "$packages"/paraview_*.deb)"
    run_logged unpack-paraview unpack_packages "$packages" "$paraview_root"
    rm -rf "$packages"
    touch "$stamp"
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
