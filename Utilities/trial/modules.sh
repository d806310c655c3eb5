#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Runs in a minimal system with /packages and /trial (this directory). Installs the packages of the
# VTK modules and uses them in C++ and in Python, first without the packages that require TetGen.
set -eu
# apt-get update may fail: the system's clock may differ from the mirror's, and the package lists of
# a frozen mirror may have expired.
apt-get update -q || true
install()
{
  apt-get install -y -q --no-install-recommends "$@"
}
install /packages/libinterlume[0-9]*.deb /packages/libinterlume-dev_*.deb \
  /packages/python3-interlume_*.deb g++ make cmake
cmake -S /trial -B /tmp/trial
cmake --build /tmp/trial
/tmp/trial/trial
python3 -c 'import interlume'
python3 /trial/classes.py
install /packages/interlume-tetgen*.deb
python3 /trial/classes.py --tetgen
rm -rf /tmp/trial
cmake -S /trial -B /tmp/trial
cmake --build /tmp/trial
/tmp/trial/trial
