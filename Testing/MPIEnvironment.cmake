# SPDX-License-Identifier: BSD-3-Clause
# What tests with several processes have in their environment, for Open MPI up to 4 and from 5 on:
# processes share the cores, and containers may forbid reading another process's memory.
set(interlume_mpi_environment
  "OMPI_MCA_rmaps_base_oversubscribe=1"
  "PRTE_MCA_rmaps_default_mapping_policy=:oversubscribe"
  "OMPI_MCA_btl_vader_single_copy_mechanism=none"
  "OMPI_ALLOW_RUN_AS_ROOT=1"
  "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1")

# interlume_ranks_test(NAME PROGRAM RANKS TIMEOUT): a test by so many processes of a program.
function (interlume_ranks_test name program ranks timeout)
  add_test(NAME ${name}
    COMMAND "${MPIEXEC_EXECUTABLE}" ${MPIEXEC_NUMPROC_FLAG} ${ranks} $<TARGET_FILE:${program}>)
  set_tests_properties(${name} PROPERTIES
    LABELS "mpi;value"
    TIMEOUT ${timeout}
    RUN_SERIAL ON
    FAIL_REGULAR_EXPRESSION " ERR\\|; WARN\\|;FATL\\|"
    ENVIRONMENT "${interlume_mpi_environment}")
endfunction ()
