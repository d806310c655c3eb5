# SPDX-License-Identifier: BSD-3-Clause
# Runs ctest in several build directories, prints a summary, and writes it to results.json next to
# the logs. Needs common.sh and paraview.sh.

result_names=()
result_runs=()
failed_runs=0
skipped=

# run_tests NAME BUILD_DIRECTORY CTEST_ARGUMENTS...
run_tests()
{
  local name=$1 folder=$2
  shift 2
  say "Testing: $name"
  mkdir -p "$log_dir"
  result_names+=("$name")
  result_runs+=("$name:$folder:$(tested_version "$name")")
  with_display ctest --test-dir "$folder" --parallel "$jobs" --output-on-failure \
    --no-tests=error "$@" 2>&1 | tee "$log_dir/test-$name.log" || failed_runs=$((failed_runs + 1))
}

# Prints the version of the tested program: ParaView, or VTK and its window class.
tested_version()
{
  local version
  if [ "$1" = paraview ]; then
    version=$(paraview_version)
    printf 'ParaView %s' "${version%%[+-]*}"
  else
    version=$(dpkg-query -W -f '${Version}' libvtk9-dev)
    printf 'VTK %s%s' "${version%%[+-]*}" "${window:+, $window}"
  fi
}

# skip WHAT WHY: prints a message now, and again in the summary. A skipped step is not a failure.
skip()
{
  say "Skipped: $1, because $2"
  skipped+="$1: skipped, because $2"$'\n'
}

# Prints ctest's summary of each run, and the skipped steps. Fails if a run failed.
report_results()
{
  local name
  say "Results"
  for name in "${result_names[@]}"; do
    printf '%s:\n' "$name"
    sed -n '/tests passed,/,$p' "$log_dir/test-$name.log" |
      sed -e '/^Label Time Summary/,/^$/d' -e '/^$/d' -e 's/^/  /'
  done
  printf '%s' "$skipped"
  python3 "$source_dir/Utilities/lib/write_results.py" "$log_dir/results.json" "$log_dir" \
    "g++ $(g++ -dumpfullversion)" "${result_runs[@]}"
  if [ "$failed_runs" -ne 0 ]; then
    printf '%d of %d test runs failed\n' "$failed_runs" "${#result_names[@]}"
    return 1
  fi
  printf 'all %d test runs passed\n' "${#result_names[@]}"
}
