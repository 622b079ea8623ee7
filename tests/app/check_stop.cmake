# SPDX-License-Identifier: LGPL-2.1-or-later
# Run the quick start until a limit is passed. The run must say that it was
# stopped, before its last cycle, and by what; the quantity must be its limit to
# 1e-9. Arguments: PROGRAM, CASE (quickstart.prm), SETTING ("Stop at ...=..."),
# MEMBER (the quantity in summary.json: its path below the joint, dots between),
# LIMIT (in SI units), MESSAGE (what it stops by), EXTRAPOLATION, NUMDIFF,
# DIRECTORY (to run in).
file(REMOVE_RECURSE ${DIRECTORY})
file(MAKE_DIRECTORY ${DIRECTORY})
execute_process(
  COMMAND ${PROGRAM} ${CASE} --output results
    --set "Bushing crank_pin/${SETTING}"
    --set "Wear/Extrapolation=${EXTRAPOLATION}"
  WORKING_DIRECTORY ${DIRECTORY}
  OUTPUT_VARIABLE _out ERROR_VARIABLE _err RESULT_VARIABLE _status)
if(NOT _status EQUAL 0)
  message(FATAL_ERROR "Exit status ${_status}\n${_out}${_err}")
endif()

file(READ ${DIRECTORY}/results/summary.json _summary)
string(JSON _run_status GET "${_summary}" status)
string(JSON _run_message GET "${_summary}" message)
string(JSON _cycles GET "${_summary}" cycles)
string(REPLACE "." ";" _path ${MEMBER})
string(JSON _value GET "${_summary}" joints crank_pin ${_path})
if(NOT _run_status STREQUAL "stopped" OR NOT _run_message STREQUAL MESSAGE
   OR NOT _cycles LESS 21400)
  message(FATAL_ERROR
    "The summary says '${_run_status}', '${_run_message}', ${_cycles} cycles.")
endif()

# CMake does not calculate with fractions.
file(WRITE ${DIRECTORY}/limit "${LIMIT}\n")
file(WRITE ${DIRECTORY}/value "${_value}\n")
execute_process(
  COMMAND ${NUMDIFF} -r 1e-9 ${DIRECTORY}/limit ${DIRECTORY}/value
  OUTPUT_VARIABLE _difference RESULT_VARIABLE _status)
if(NOT _status EQUAL 0)
  message(FATAL_ERROR
    "The run stopped at ${_value}, and should at ${LIMIT}:\n${_difference}")
endif()
message("Stopped at ${_value}.")
