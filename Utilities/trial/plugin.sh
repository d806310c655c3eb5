#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Runs in a minimal system with /packages and /trial (this directory). Installs ParaView and the
# packages of the plugin, or unpacks the plugin's archive and installs what its README names. ParaView
# must find the plugin, and a script by PV_PLUGIN_PATH. Without it, the script must fail.
set -eu
# apt-get update may fail: the system's clock may differ from the mirror's, and the package lists of
# a frozen mirror may have expired.
apt-get update -q || true
install()
{
  apt-get install -y -q --no-install-recommends "$@" xvfb xauth libgl1-mesa-dri libglx-mesa0
}
archive=$(find /packages -name '*.tar.xz')
if [ -n "$archive" ]; then
  apt-get install -y -q --no-install-recommends xz-utils
  tar -C /opt -xf "$archive"
  cd /opt/interlume-*
  grep 'apt-get install' README.md
  install $(sed -n 's/^ *sudo apt-get install //p' README.md)
  folder=$PWD/Interlume
  search=--plugin-search-paths=$folder
else
  install /packages/paraview-interlume*.deb python3-paraview
  folder=$(dirname "$(dpkg -L paraview-interlume | grep '/Interlume\.so$')")
  search=
fi
export LIBGL_ALWAYS_SOFTWARE=1
echo "Loading the plugin by its name"
xvfb-run -a timeout 600 paraview $search --plugins=Interlume --script=/trial/plugin.py
echo "Loading the plugin by PV_PLUGIN_PATH"
PV_PLUGIN_PATH=$folder xvfb-run -a pvbatch /trial/plugin.py
echo "Without the plugin, which must fail"
if xvfb-run -a pvbatch /trial/plugin.py; then
  echo "the script succeeds without the plugin: it does not test the plugin"
  exit 1
fi
