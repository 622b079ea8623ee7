# SPDX-License-Identifier: LGPL-2.1-or-later
# Run the quick start until a limit is passed. The run must say that it was
# stopped, before its last cycle, and by what; the quantity must be its limit to
# 1e-9. Arguments: PROGRAM, CASE (quickstart.prm), QUANTITY (clearance, volume
# or mass), EXTRAPOLATION, NUMDIFF, DIRECTORY (to run in).
if(QUANTITY STREQUAL "clearance")
  # Of 0.01 mm at the beginning.
  set(_setting "Stop at clearance=0.2 mm")
  set(_member clearance_m)
  set(_limit 2e-4)
  set(_message "crank_pin: clearance 0.2 mm")
elseif(QUANTITY STREQUAL "volume")
  set(_setting "Stop at worn volume=20 mm^3")
  set(_member bushing worn_volume_m3)
  set(_limit 2e-8)
  set(_message "crank_pin: worn volume 20 mm^3")
elseif(QUANTITY STREQUAL "mass")
  set(_setting "Stop at worn mass=0.05 g")
  set(_member bushing worn_mass_kg)
  set(_limit 5e-5)
  set(_message "crank_pin: worn mass 0.05 g")
endif()

file(REMOVE_RECURSE ${DIRECTORY})
file(MAKE_DIRECTORY ${DIRECTORY})
execute_process(
  COMMAND ${PROGRAM} ${CASE} --output results
    --set "Bushing crank_pin/${_setting}"
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
string(JSON _value GET "${_summary}" joints crank_pin ${_member})
if(NOT _run_status STREQUAL "stopped" OR NOT _run_message STREQUAL _message
   OR NOT _cycles LESS 21400)
  message(FATAL_ERROR
    "The summary says '${_run_status}', '${_run_message}', ${_cycles} cycles.")
endif()

# CMake does not calculate with fractions.
file(WRITE ${DIRECTORY}/limit "${_limit}\n")
file(WRITE ${DIRECTORY}/value "${_value}\n")
execute_process(
  COMMAND ${NUMDIFF} -r 1e-9 ${DIRECTORY}/limit ${DIRECTORY}/value
  OUTPUT_VARIABLE _difference RESULT_VARIABLE _status)
if(NOT _status EQUAL 0)
  message(FATAL_ERROR
    "The run stopped at ${_value}, and should at ${_limit}:\n${_difference}")
endif()
message("Stopped at ${_value}.")
