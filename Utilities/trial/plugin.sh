#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Runs in a minimal system with /packages and /trial (this directory). Installs ParaView and the
# packages of the plugin. ParaView must find the plugin by its name in the plugin directory, and by
# PV_PLUGIN_PATH. Without either, the script must fail.
set -eu
# apt-get update may fail: the system's clock may differ from the mirror's, and the package lists of
# a frozen mirror may have expired.
apt-get update -q || true
apt-get install -y -q --no-install-recommends /packages/paraview-interlume*.deb python3-paraview \
  xvfb xauth libgl1-mesa-dri libglx-mesa0
folder=$(dirname "$(dpkg -L paraview-interlume | grep '/Interlume\.so$')")
export LIBGL_ALWAYS_SOFTWARE=1
echo "Loading the plugin by its name"
xvfb-run -a timeout 600 paraview --plugins=Interlume --script=/trial/plugin.py
echo "Loading the plugin by PV_PLUGIN_PATH"
PV_PLUGIN_PATH=$folder xvfb-run -a pvbatch /trial/plugin.py
echo "Without the plugin, which must fail"
if xvfb-run -a pvbatch /trial/plugin.py; then
  echo "the script succeeds without the plugin: it does not test the plugin"
  exit 1
fi
