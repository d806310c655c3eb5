#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Runs in a minimal system with /packages. Builds a module from the source archive, without git.
set -euo pipefail
if command -v git; then
  echo "git is installed: this does not test a build without it"
  exit 1
fi
apt-get update -q || true
apt-get install -y -q --no-install-recommends xz-utils
tar -C /opt -xf /packages/interlume-*.tar.xz
cd /opt/interlume-*
. Utilities/lib/common.sh
. Utilities/lib/packages.sh
install_packages modules "${module_packages[@]}" "${vtk_packages[@]}"
cmake -S . --preset packages
cmake --build --preset packages --target InterlumeIsotables
ls -l build/packages/lib/*/libInterlumeIsotables.so
