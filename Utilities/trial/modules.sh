#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# In a fresh system with /packages and this folder as /trial: installs the packages of the VTK modules, and
# uses them in C++ and in Python, first without those that need TetGen.
set -eu
# The system may be of another day than the mirror; a mirror that stands still has lists that have expired.
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
