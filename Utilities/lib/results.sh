# Runs ctest over several build folders and says at the end what came out. Needs common.sh.

result_names=()
failed_runs=0

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

# Prints ctest's closing lines of every run; fails if one failed.
report_results()
{
  local name
  say "Results"
  for name in "${result_names[@]}"; do
    printf '%s:\n' "$name"
    sed -n '/tests passed,/,$p' "$log_dir/test-$name.log" |
      sed -e '/^Label Time Summary/,/^$/d' -e '/^$/d' -e 's/^/  /'
  done
  if [ "$failed_runs" -ne 0 ]; then
    printf '%d of %d test runs failed\n' "$failed_runs" "${#result_names[@]}"
    return 1
  fi
  printf 'all %d test runs passed\n' "${#result_names[@]}"
}
