# SPDX-License-Identifier: BSD-3-Clause
# Functions shared by the commands in Utilities/: messages, logged steps, the build directory, a
# display. Source it from bash with `set -euo pipefail`.

source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build_root=$source_dir/build
log_dir=$build_root/logs
jobs=$(nproc)
started=$SECONDS

say()
{
  printf '[%4d s] %s\n' $((SECONDS - started)) "$*"
}

die()
{
  printf 'error: %s\n' "$*" >&2
  exit 1
}

# Prints the comment block at the top of the calling script, which is its help text.
show_help()
{
  sed -n '3,/^[^#]/{/^#/s/^# \{0,1\}//p}' "$0"
}

# run_logged NAME COMMAND...: redirects output to a log. Shows the last line of the log
# periodically, and the end of the log if the command fails.
run_logged()
{
  local name=$1 log=$log_dir/$1.log pid status=0 waited=0
  shift
  mkdir -p "$log_dir"
  "$@" >"$log" 2>&1 &
  pid=$!
  trap 'kill "$pid" 2>/dev/null; exit 130' INT TERM
  while kill -0 "$pid" 2>/dev/null; do
    sleep 1
    waited=$((waited + 1))
    if [ $((waited % 20)) -eq 0 ]; then
      say "  … $(tail -n 1 "$log" | cut -c 1-90)"
    fi
  done
  wait "$pid" || status=$?
  trap - INT TERM
  if [ "$status" -ne 0 ]; then
    tail -n 40 "$log" >&2
    die "$name failed with status $status; see the output in $log"
  fi
}

# Configures the preset and builds the given targets, or all targets.
build_preset()
{
  local preset=$1 target
  local -a targets=()
  shift
  for target in "$@"; do
    targets+=(--target "$target")
  done
  say "Building preset $preset with $jobs jobs"
  run_logged "configure-$preset" cmake -S "$source_dir" --preset "$preset"
  (cd "$source_dir" &&
    cmake --build --preset "$preset" --parallel "$jobs" ${targets[@]+"${targets[@]}"})
}

# Runs a command on a virtual display, so that images do not depend on the desktop's driver. If
# `window` is set to a VTK window class that needs no display, uses that class instead. The display
# accepts more clients than by default, since each process of a parallel run opens windows. It does
# not reset when the last client disconnects, since during a reset it would reject new clients.
with_display()
{
  if [ -n "${window:-}" ]; then
    env -u DISPLAY LIBGL_ALWAYS_SOFTWARE=1 VTK_DEFAULT_OPENGL_WINDOW="$window" "$@"
  else
    LIBGL_ALWAYS_SOFTWARE=1 xvfb-run -a -s "-screen 0 1280x1024x24 -maxclients 512 -noreset" "$@"
  fi
}
