# SPDX-License-Identifier: BSD-3-Clause
# Packs an archive of the ParaView plugin from its Debian packages. Needs common.sh and paraview.sh.

# make_plugin_archive FOLDER SUITE: packs the plugin of the packages in FOLDER into an archive there.
make_plugin_archive()
{
  local folder=$1 suite=$2 work=$1/archive package version paraview tetgen name top
  package=$(echo "$folder"/paraview-interlume_*.deb)
  version=$(dpkg-deb -f "$package" Version)
  paraview=$(paraview_version)
  tetgen=$(dpkg-deb -f "$folder"/paraview-interlume-tetgen_*.deb Depends | grep -o 'libtet[^ ,]*') ||
    die "paraview-interlume-tetgen does not depend on TetGen's library"
  name=interlume-${version%-*}-paraview-$(cut -d . -f 1,2 <<<"$paraview")-$suite-$(dpkg-deb -f "$package" Architecture)
  top=$work/$name
  say "Packing $name.tar.xz"
  rm -rf "$work" "$folder"/*.tar.xz
  mkdir -p "$top/licenses"
  unpack_packages "$folder" "$work/root"
  cp -a "$(dirname "$(find "$work/root" -name Interlume.so)")" "$top/Interlume"
  cp "$source_dir/LICENSE" "$top/"
  cp "$work/root/usr/share/doc/paraview-interlume/"{copyright,third-party.spdx.json} "$top/licenses/"
  cp "$source_dir/Filters/Meshing/Worker/LICENSE" "$top/licenses/AGPL-3.0"
  # The texts that the copyright file refers to.
  grep -o '/usr/share/common-licenses/[A-Za-z]*-[0-9.]*[0-9]' "$top/licenses/copyright" | sort -u |
    xargs cp -L -t "$top/licenses"
  print_plugin_readme "${version%-*}" "$paraview" "$tetgen" >"$top/README.md"
  tar -C "$work" --sort=name --owner=root:0 --group=root:0 -cf - "$name" | xz -9 >"$folder/$name.tar.xz"
  rm -rf "$work"
}

# print_plugin_readme VERSION PARAVIEW TETGEN: TETGEN is the package of TetGen's library.
print_plugin_readme()
{
  cat <<EOF
# Interlume $1 for ParaView $(cut -d . -f 1,2 <<<"$2")

A plugin with the filters and the volume rendering of Interlume, built for:

    package paraview $2
    $(. /etc/os-release && echo "$PRETTY_NAME"), $(dpkg --print-architecture)

It does not work with another minor version of ParaView, with another Debian release, or with the programs
of paraview.org, which contain other libraries.

## Load the plugin

Install ParaView, and TetGen's library for the filter *Tetrahedral Mesher*:

    sudo apt-get install paraview python3-paraview $3

Then start ParaView in this directory:

    paraview --plugin-search-paths="\$PWD/Interlume" --plugins=Interlume

In a running ParaView: Tools, Manage Plugins, Load New, and the file Interlume/Interlume.so. Scripts load
all plugins in PV_PLUGIN_PATH:

    PV_PLUGIN_PATH=\$PWD/Interlume pvbatch script.py

## Licenses

Interlume has the BSD 3-Clause license (LICENSE). licenses/copyright names the license of each part and of
each library, and the other files there are the texts. Interlume/InterlumeTetGen is a separate program that
is linked to TetGen, and has the AGPL (licenses/AGPL-3.0). Only the Tetrahedral Mesher runs it; it can be
deleted. Its source is in Filters/Meshing/Worker of interlume-$1.tar.xz, and TetGen's source is Debian's
source package tetgen.
EOF
}
