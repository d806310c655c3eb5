# SPDX-License-Identifier: BSD-3-Clause
# Runs the value and stability tests with a sanitizer. Needs common.sh and results.sh.

# test_with_sanitizer address|thread: the argument also selects the preset and the suppressions. The
# presets build no programs and no Python modules. Excludes the project that uses the installed
# package, which is not instrumented.
test_with_sanitizer()
{
  local name=$1 suppressions=$source_dir/Utilities/sanitizers
  build_preset "sanitize-$name"
  # Use the thread pool of the standard library instead of TBB, since ThreadSanitizer sees its
  # locks. The OpenGL driver, whose locks are not visible either, draws in one thread without a cache
  # for shaders.
  LP_NUM_THREADS=0 MESA_SHADER_CACHE_DISABLE=true \
  VTK_SMP_BACKEND_IN_USE=STDThread \
  ASAN_OPTIONS=detect_leaks=1:detect_odr_violation=0 \
  LSAN_OPTIONS="suppressions=$suppressions/leaks.txt:print_suppressions=0" \
  UBSAN_OPTIONS=print_stacktrace=1:halt_on_error=1 \
  TSAN_OPTIONS="suppressions=$suppressions/races.txt:halt_on_error=1:second_deadlock_stack=1" \
    run_tests "sanitize-$name" "$build_root/sanitize-$name" --label-regex 'value|stability' \
    --exclude-regex TestInstalledPackage
}
