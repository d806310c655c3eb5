# SPDX-License-Identifier: BSD-3-Clause
# What tests with several processes have in their environment, for Open MPI up to 4 and from 5 on:
# processes share the cores, and containers may forbid reading another process's memory.
set(interlume_mpi_environment
  "OMPI_MCA_rmaps_base_oversubscribe=1"
  "PRTE_MCA_rmaps_default_mapping_policy=:oversubscribe"
  "OMPI_MCA_btl_vader_single_copy_mechanism=none"
  "OMPI_ALLOW_RUN_AS_ROOT=1"
  "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1")
