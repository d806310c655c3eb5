# SPDX-License-Identifier: BSD-3-Clause
# Installs what a Debian machine lacks. Needs common.sh.

# What the modules need besides VTK, or ParaView: the two cannot be installed together. Where a
# package's name differs between Debian's versions, the names have | between them.
module_packages=(
  g++ cmake ninja-build libboost-dev libeigen3-dev libglm-dev 'libtet1.5-dev | libtet-dev')

# VTK with what wraps classes for Python, which libvtk9-dev brings, and NumPy, which it does not.
vtk_packages=(libvtk9-dev libpython3-dev python3-vtk9 python3-numpy)

build_packages=(
  "${module_packages[@]}" "${vtk_packages[@]}"
  libcli11-dev nlohmann-json3-dev
  xvfb xauth libgl1-mesa-dri libglx-mesa0)

# What ParaView's CMake package asks for, and a window manager for the tests of its client; its own
# run-time libraries are read from its package. ParaView 5.11 is of Qt 5, later ones are of Qt 6; 6.1
# has no VTK of its own but Debian's, and makes its help with a tool of Qt 5.
paraview_build_packages=(
  libtool-bin libopenmpi-dev openmpi-bin python3-mpi4py python3-numpy openbox)
paraview_qt5_packages=(
  qtbase5-dev qttools5-dev qttools5-dev-tools libqt5svg5-dev libqt5opengl5-dev
  libqt5x11extras5-dev libqt5xmlpatterns5-dev qtxmlpatterns5-dev-tools)
paraview_qt6_packages=(
  qt6-base-dev qt6-tools-dev qt6-tools-dev-tools qt6-svg-dev qt6-5compat-dev)
paraview_6_packages=(
  libvtk9-dev libvtk9-qt-dev libpython3-dev python3-vtk9 qtxmlpatterns5-dev-tools)

as_root()
{
  if [ "$(id -u)" -eq 0 ]; then
    env DEBIAN_FRONTEND=noninteractive "$@"
  elif command -v sudo >/dev/null; then
    sudo env DEBIAN_FRONTEND=noninteractive "$@"
  else
    die "packages are missing, and this user is neither root nor has sudo; as root, run: $*"
  fi
}

# apt_get ARGUMENTS...: with the package lists as they are; with new ones if that fails.
apt_get()
{
  local -a command=(apt-get -y -q -o DPkg::Lock::Timeout=600 --no-install-recommends "$@")
  as_root "${command[@]}" || { as_root apt-get -q update && as_root "${command[@]}"; }
}

# is_installed PACKAGE: or, of several with | between them, any.
is_installed()
{
  local package
  for package in ${1//|/ }; do
    [ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null)" = installed ] && return
  done
  return 1
}

# install_packages NAME PACKAGE...: NAME is what the log is called.
install_packages()
{
  local name=$1 package missing=
  shift
  command -v apt-get >/dev/null || die "this needs a Debian system; elsewhere install: $*"
  for package in "$@"; do
    is_installed "$package" || missing+="${missing:+, }$package"
  done
  if [ -n "$missing" ]; then
    say "Installing $missing"
    run_logged "install-$name" apt_get satisfy "$missing"
  fi
}

# Prints the version of a package that apt would install; nothing where there is none, by new package
# lists too.
available_version()
{
  local -a show=(apt-cache show --no-all-versions "$1")
  { "${show[@]}" || { as_root apt-get -q update >&2 && "${show[@]}"; }; } 2>/dev/null |
    sed -n 's/^Version: //p' || true
}
