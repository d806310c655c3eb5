# SPDX-License-Identifier: BSD-3-Clause
# Runs a command of Utilities/, or a script of Utilities/trial, in a minimal Debian system that is
# installed in a directory. Needs common.sh and packages.sh.

suites_dir=${INTERLUME_SUITES:-$build_root/suites}
suites_known='bookworm trixie sid'

# run_in_suite SUITE COMMAND...: runs COMMAND, which is relative to the source directory. The first
# call creates the system. Later calls reuse it with its installed packages and builds, and copy
# only changed files.
run_in_suite()
{
  local suite=$1 root=$suites_dir/$1
  shift
  make_suite "$suite" "$root"
  copy_source "$root"
  say "Running $* in $root"
  enter_suite "$root" /src "$@"
}

# make_suite SUITE ROOT: creates a minimal Debian in the directory ROOT if it does not exist.
make_suite()
{
  local suite=$1 root=$2 mirror
  case " $suites_known " in
    *" $suite "*) ;;
    *) die "unknown suite $suite; supported suites: ${suites_known// /, }" ;;
  esac
  install_packages suite debootstrap util-linux
  if [ ! -d "$root" ]; then
    say "Creating Debian $suite in $root"
    mkdir -p "$suites_dir"
    as_root rm -rf "$root.part"
    mirror=$(debian_mirror)
    run_logged "make-$suite" as_root debootstrap --variant=minbase --include=ca-certificates \
      "$suite" "$root.part" ${mirror:+"$mirror"}
    as_root mv "$root.part" "$root"
  fi
}

# enter_suite ROOT DIRECTORY COMMAND...: runs COMMAND in DIRECTORY of the system in ROOT.
enter_suite()
{
  local root=$1 propagation=private
  # If this already runs inside such a system, mount propagation cannot be changed.
  as_root unshare --mount true 2>/dev/null || propagation=unchanged
  # The mounts exist only in the mount namespace of the command.
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

# Prints the name of the current system's suite.
current_suite()
{
  # In unstable, os-release contains the name of the next stable release.
  case $(cat /etc/debian_version) in
    */sid) echo sid ;;
    *) (. /etc/os-release && echo "$VERSION_CODENAME") ;;
  esac
}

# try_in_suite SUITE NAME SCRIPT FILE...: runs a script of Utilities/trial in a copy of a minimal
# system of the suite. In the copy, Utilities/trial is /trial, and the files are in /packages. Only
# root can do this; for other users, prints a message.
try_in_suite()
{
  local suite=$1 name=$2 script=$3 base=$suites_dir/$1.fresh root=$suites_dir/try-$2
  shift 3
  if [ "$(id -u)" -ne 0 ]; then
    say "Skipped: the test in a minimal system, $name, because this user is not root"
    return
  fi
  make_suite "$suite" "$base"
  # This makes dpkg faster, but a crash of the machine may damage the system, which must then be
  # created again.
  printf 'force-unsafe-io\n' >"$base/etc/dpkg/dpkg.cfg.d/unsafe-io"
  rm -rf --one-file-system "$root"
  cp -a "$base" "$root"
  cp -a "$source_dir/Utilities/trial" "$root/trial"
  mkdir "$root/packages"
  cp "$@" "$root/packages/"
  say "Testing in a minimal system: $name"
  run_logged "try-$name" enter_suite "$root" / "/trial/$script"
  sed -n '/ tetrahedra /s/^/  /p' "$log_dir/try-$name.log"
  rm -rf --one-file-system "$root"
}

# Prints the Debian mirror that the current system uses. Prints nothing if there is none;
# debootstrap then uses its default.
debian_mirror()
{
  cat /etc/apt/sources.list /etc/apt/sources.list.d/* 2>/dev/null |
    sed -nE 's/^(URIs: |deb (\[[^]]*\] )?)(http[^ ]*\/debian)\/?( .*)?$/\3/p' | head -n 1 || true
}

# Copies all files of the source directory except build results. Only changed files get a new
# modification time, so that the rest is not rebuilt. Deleted files are deleted in the copy.
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
