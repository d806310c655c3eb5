# SPDX-License-Identifier: BSD-3-Clause
# cmake -D "MPIEXEC=mpiexec;-n" -D PROGRAM=interlume-bench-ranks -D FOLDER=folder -P RunRanks.cmake
# Runs the program with one and with two processes and joins the results in FOLDER/ranks.json.
cmake_minimum_required(VERSION 3.16)
foreach (ranks IN ITEMS 1 2)
  execute_process(COMMAND ${MPIEXEC} ${ranks} "${PROGRAM}" --tiny --json "${FOLDER}/ranks-${ranks}.json"
    RESULT_VARIABLE result)
  if (result)
    message(FATAL_ERROR "ERROR: ${PROGRAM} with ${ranks} processes exited with ${result}")
  endif ()
endforeach ()
execute_process(COMMAND "${PROGRAM}" --from "${FOLDER}/ranks-1.json" --from "${FOLDER}/ranks-2.json"
  --json "${FOLDER}/ranks.json" RESULT_VARIABLE result)
if (result)
  message(FATAL_ERROR "ERROR: ${PROGRAM} --from exited with ${result}")
endif ()
