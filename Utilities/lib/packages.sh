# SPDX-License-Identifier: BSD-3-Clause
# Installs missing Debian packages. Needs common.sh.

# Packages that the modules require in addition to VTK or ParaView, which cannot be installed
# together. If a package has different names in different Debian releases, the names are separated
# by |.
module_packages=(
  g++ cmake ninja-build libboost-dev libeigen3-dev libglm-dev 'libtet1.5-dev | libtet-dev')

# VTK with its tools for wrapping classes in Python, and NumPy. libvtk9-dev does not depend on them.
vtk_packages=(libvtk9-dev libpython3-dev python3-vtk9 python3-numpy)

build_packages=(
  "${module_packages[@]}" "${vtk_packages[@]}"
  libcli11-dev nlohmann-json3-dev
  xvfb xauth libgl1-mesa-dri libglx-mesa0)

# Requirements of ParaView's CMake package, and a window manager for the tests of ParaView's client.
# The run-time dependencies are read from the package. ParaView 5.11 uses Qt 5, later versions use
# Qt 6. ParaView 6.1 uses Debian's VTK and builds its help with a tool of Qt 5.
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
    die "packages are missing, and this user is not root and has no sudo; as root, run: $*"
  fi
}

# apt_get ARGUMENTS...: runs apt-get. If it fails, updates the package lists and retries.
apt_get()
{
  local -a command=(apt-get -y -q -o DPkg::Lock::Timeout=600 --no-install-recommends "$@")
  as_root "${command[@]}" || { as_root apt-get -q update && as_root "${command[@]}"; }
}

# is_installed PACKAGE: succeeds if the package, or any of several separated by |, is installed.
is_installed()
{
  local package
  for package in ${1//|/ }; do
    [ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null)" = installed ] && return
  done
  return 1
}

# install_packages NAME PACKAGE...: installs missing packages. NAME is the name of the log.
install_packages()
{
  local name=$1 package missing=
  shift
  command -v apt-get >/dev/null || die "packages can be installed automatically only on Debian; install: $*"
  for package in "$@"; do
    is_installed "$package" || missing+="${missing:+, }$package"
  done
  if [ -n "$missing" ]; then
    say "Installing $missing"
    run_logged "install-$name" apt_get satisfy "$missing"
  fi
}

# Prints the version of a package that apt would install. Updates the package lists if the package
# is unknown; prints nothing if it is not available.
available_version()
{
  local -a show=(apt-cache show --no-all-versions "$1")
  { "${show[@]}" || { as_root apt-get -q update >&2 && "${show[@]}"; }; } 2>/dev/null |
    sed -n 's/^Version: //p' || true
}
