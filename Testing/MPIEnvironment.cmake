# SPDX-License-Identifier: BSD-3-Clause
# Environment of tests with several processes, for Open MPI before and since version 5: allow
# oversubscription, and avoid reading the memory of other processes, which containers may forbid.
set(interlume_mpi_environment
  "OMPI_MCA_rmaps_base_oversubscribe=1"
  "PRTE_MCA_rmaps_default_mapping_policy=:oversubscribe"
  "OMPI_MCA_btl_vader_single_copy_mechanism=none"
  "OMPI_ALLOW_RUN_AS_ROOT=1"
  "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1")

# interlume_ranks_test(NAME PROGRAM RANKS TIMEOUT): adds a test that runs PROGRAM with RANKS processes.
function (interlume_ranks_test name program ranks timeout)
  set(environment ${interlume_mpi_environment})
  if (INTERLUME_SANITIZE)
    math(EXPR timeout "6 * ${timeout}")
    # Open MPI unloads its modules before leak detection, so their memory cannot be suppressed by name.
    list(APPEND environment "ASAN_OPTIONS=detect_leaks=0:detect_odr_violation=0")
  endif ()
  add_test(NAME ${name}
    COMMAND "${MPIEXEC_EXECUTABLE}" ${MPIEXEC_NUMPROC_FLAG} ${ranks} $<TARGET_FILE:${program}>)
  set_tests_properties(${name} PROPERTIES
    LABELS "mpi;value"
    TIMEOUT ${timeout}
    RUN_SERIAL ON
    FAIL_REGULAR_EXPRESSION " ERR\\|; WARN\\|;FATL\\|"
    ENVIRONMENT "${environment}")
endfunction ()
