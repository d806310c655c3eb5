# SPDX-License-Identifier: BSD-3-Clause
# Fresh Debian roots in folders, of this system's suite and mirror. Needs common.sh and packages.sh, and
# to be root.

base_root=$build_root/fresh-root

# make_base_root: a minimal system, made once.
make_base_root()
{
  local suite mirror
  if [ ! -e "$base_root/.made" ]; then
    install_packages roots debootstrap
    suite=$(. /etc/os-release && printf '%s' "${VERSION_CODENAME:-sid}")
    mirror=$(sed -nE 's/^(URIs: |deb (\[[^]]*\] )?)(http[^ ]*\/debian)\/?( .*)?$/\3/p' \
      /etc/apt/sources.list /etc/apt/sources.list.d/* 2>/dev/null | head -n 1)
    say "Making a fresh root of $suite"
    rm -rf "$base_root"
    run_logged fresh-root debootstrap --variant=minbase --include=ca-certificates "$suite" \
      "$base_root" "${mirror:-http://deb.debian.org/debian}"
    cp /etc/resolv.conf /etc/hosts "$base_root/etc/"
    find /etc/apt/apt.conf.d -name '*proxy*' -exec cp {} "$base_root/etc/apt/apt.conf.d/" \;
    # What a fault could lose here is made anew.
    printf 'force-unsafe-io\n' >"$base_root/etc/dpkg/dpkg.cfg.d/unsafe-io"
    touch "$base_root/.made"
  fi
}

# try_in_root NAME FOLDER SCRIPT: runs FOLDER/SCRIPT in a copy of the fresh root, in which FOLDER is
# /trial and the packages are in /packages. What is mounted there ends with the command.
try_in_root()
{
  local name=$1 folder=$2 script=$3 root=$build_root/root-$1
  shift 3
  make_base_root
  rm -rf "$root"
  cp -a "$base_root" "$root"
  cp -a "$folder" "$root/trial"
  mkdir "$root/packages"
  cp "$@" "$root/packages/"
  say "Trying in a fresh root: $name"
  run_logged "try-$name" unshare --mount env -i HOME=/root LANG=C.UTF-8 DEBIAN_FRONTEND=noninteractive \
    PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
    http_proxy="${http_proxy:-}" https_proxy="${https_proxy:-}" sh -euc '
      mount -t proc proc "$1/proc"
      mount -t sysfs -o ro sysfs "$1/sys"
      mount --rbind /dev "$1/dev"
      exec chroot "$1" "/trial/$2"' sh "$root" "$script"
  sed -n '/ tetrahedra /s/^/  /p' "$log_dir/try-$name.log"
  rm -rf "$root"
}
