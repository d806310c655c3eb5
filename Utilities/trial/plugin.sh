#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# In a fresh system with /packages and this folder as /trial: installs ParaView and the plugin's packages,
# and has ParaView find the plugin by its name in the folder of plugins, and by PV_PLUGIN_PATH. Without
# either the script fails.
set -eu
# The system may be of another day than the mirror; a mirror that stands still has lists that have expired.
apt-get update -q || true
apt-get install -y -q --no-install-recommends /packages/paraview-interlume*.deb python3-paraview \
  xvfb xauth libgl1-mesa-dri libglx-mesa0
folder=$(dirname "$(dpkg -L paraview-interlume | grep '/Interlume\.so$')")
export LIBGL_ALWAYS_SOFTWARE=1
echo "By its name"
xvfb-run -a timeout 600 paraview --plugins=Interlume --script=/trial/plugin.py
echo "By PV_PLUGIN_PATH"
PV_PLUGIN_PATH=$folder xvfb-run -a pvbatch /trial/plugin.py
echo "By nothing"
if xvfb-run -a pvbatch /trial/plugin.py; then
  echo "the script passes without the plugin: it shows nothing"
  exit 1
fi
