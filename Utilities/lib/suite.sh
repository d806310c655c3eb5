# SPDX-License-Identifier: BSD-3-Clause
# Runs a command of Utilities/ in a Debian system of its own, in a folder. Needs common.sh and
# packages.sh.

suites_dir=${INTERLUME_SUITES:-$build_root/suites}
suites_known='bookworm trixie sid'

# run_in_suite SUITE COMMAND...: COMMAND is relative to the source folder. The system is made at the
# first call; later ones reuse it, with what was installed and built there, and copy the files that
# have changed since.
run_in_suite()
{
  local suite=$1 root=$suites_dir/$1
  shift
  make_suite "$suite" "$root"
  copy_source "$root"
  say "Running $* in $root"
  enter_suite "$root" /src "$@"
}

# make_suite SUITE ROOT: a minimal Debian in the folder ROOT, unless it is there.
make_suite()
{
  local suite=$1 root=$2 mirror
  case " $suites_known " in
    *" $suite "*) ;;
    *) die "unknown suite $suite; known are: ${suites_known// /, }" ;;
  esac
  install_packages suite debootstrap util-linux
  if [ ! -d "$root" ]; then
    say "Making Debian $suite in $root"
    mkdir -p "$suites_dir"
    as_root rm -rf "$root.part"
    mirror=$(debian_mirror)
    run_logged "make-$suite" as_root debootstrap --variant=minbase --include=ca-certificates \
      "$suite" "$root.part" ${mirror:+"$mirror"}
    as_root mv "$root.part" "$root"
  fi
}

# enter_suite ROOT FOLDER COMMAND...: runs COMMAND in FOLDER of the system in ROOT.
enter_suite()
{
  local root=$1 propagation=private
  # In a folder that is itself such a system there is nothing to make private.
  as_root unshare --mount true 2>/dev/null || propagation=unchanged
  # The mounts end with the command's own namespace.
  as_root unshare --mount --propagation $propagation bash -euc '
    root=$1 folder=$2
    shift 2
    mount -t proc proc "$root/proc"
    mount -t sysfs -o ro sysfs "$root/sys"
    mount --rbind /dev "$root/dev"
    mount -t tmpfs tmpfs "$root/dev/shm"
    cp /etc/resolv.conf /etc/hosts "$root/etc/" 2>/dev/null || true
    cp -n /etc/apt/apt.conf.d/*proxy* "$root/etc/apt/apt.conf.d/" 2>/dev/null || true
    cd "$root"
    exec env -i HOME=/root LANG=C.UTF-8 PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
      DEBIAN_FRONTEND=noninteractive http_proxy="${http_proxy:-}" https_proxy="${https_proxy:-}" \
      chroot "$root" bash -c "cd \"\$1\" && shift && exec \"\$@\"" bash "$folder" "$@"' bash "$@"
}

# The mirror that this system uses; nothing where it names none, for debootstrap's own.
debian_mirror()
{
  cat /etc/apt/sources.list /etc/apt/sources.list.d/* 2>/dev/null |
    sed -nE 's/^(URIs: |deb (\[[^]]*\] )?)(http[^ ]*\/debian)\/?( .*)?$/\3/p' | head -n 1 || true
}

# All files but what was built. Those that differ are new there, whatever their times are here, so that
# they alone are built again; those that are gone leave the copy too.
copy_source()
{
  local root=$1 list=$1/src.files files=$log_dir/suite-files changed=$log_dir/suite-changed file
  mkdir -p "$log_dir"
  (cd "$source_dir" && find . \( -path ./build -o -path ./.git \) -prune -o ! -type d -print | sort) >"$files"
  as_root mkdir -p "$root/src"
  if [ -f "$list" ]; then
    comm -23 "$list" "$files" | while IFS= read -r file; do as_root rm -f "$root/src/$file"; done
    as_root find "$root/src" -path "$root/src/build" -prune -o -type d -empty -exec rmdir {} +
  fi
  while IFS= read -r file; do
    cmp -s "$source_dir/$file" "$root/src/$file" || printf '%s\n' "$file"
  done <"$files" >"$changed"
  tar -C "$source_dir" -cf - -T "$changed" | as_root tar -C "$root/src" -xmf - --no-same-owner
  as_root cp "$files" "$list"
}
