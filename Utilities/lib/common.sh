# SPDX-License-Identifier: BSD-3-Clause
# Shared by the commands in Utilities/: messages, steps with a log, the build folder, a display.
# To be sourced by bash with `set -euo pipefail`.

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

# Prints the comment block at the top of the calling script, which is its help.
show_help()
{
  sed -n '3,/^[^#]/{/^#/s/^# \{0,1\}//p}' "$0"
}

# run_logged NAME COMMAND...: output goes to a log; its last line is shown now and then, and the end
# of it when the command fails.
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
    die "$name failed with status $status; all of its output is in $log"
  fi
}

# Configures the preset when needed and builds the targets named, or all of them.
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

# Runs a command on a virtual display, so that a picture never depends on the desktop's driver; or
# where `window` names VTK's class of window that needs no display, in those. The display takes more
# clients than usual, since each rank of a parallel run opens windows of its own, and does not reset
# when the last of them leaves: the next, arriving meanwhile, would be turned away.
with_display()
{
  if [ -n "${window:-}" ]; then
    env -u DISPLAY LIBGL_ALWAYS_SOFTWARE=1 VTK_DEFAULT_OPENGL_WINDOW="$window" "$@"
  else
    LIBGL_ALWAYS_SOFTWARE=1 xvfb-run -a -s "-screen 0 1280x1024x24 -maxclients 512 -noreset" "$@"
  fi
}
