# SPDX-License-Identifier: BSD-3-Clause
# Runs ctest over several build folders and says at the end what came out. Needs common.sh.

result_names=()
failed_runs=0
left_out=

# run_tests NAME BUILD_FOLDER CTEST_ARGUMENTS...
run_tests()
{
  local name=$1 folder=$2
  shift 2
  say "Testing: $name"
  mkdir -p "$log_dir"
  result_names+=("$name")
  with_display ctest --test-dir "$folder" --parallel "$jobs" --output-on-failure \
    --no-tests=error "$@" 2>&1 | tee "$log_dir/test-$name.log" || failed_runs=$((failed_runs + 1))
}

# leave_out WHAT WHY: is said at once, and again among the results; nothing fails by it.
leave_out()
{
  say "Left out: $1, since $2"
  left_out+="$1: left out, since $2"$'\n'
}

# Prints ctest's closing lines of every run, and what was left out; fails if a run failed.
report_results()
{
  local name
  say "Results"
  for name in "${result_names[@]}"; do
    printf '%s:\n' "$name"
    sed -n '/tests passed,/,$p' "$log_dir/test-$name.log" |
      sed -e '/^Label Time Summary/,/^$/d' -e '/^$/d' -e 's/^/  /'
  done
  printf '%s' "$left_out"
  if [ "$failed_runs" -ne 0 ]; then
    printf '%d of %d test runs failed\n' "$failed_runs" "${#result_names[@]}"
    return 1
  fi
  printf 'all %d test runs passed\n' "${#result_names[@]}"
}
