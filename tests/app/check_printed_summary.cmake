# SPDX-License-Identifier: LGPL-2.1-or-later
# Run a case and compare what the program prints line by line with the file
# NAME.output: the words exactly, numbers to 2e-3, as much as another compiler
# may change. Times are masked, and so are errors and differences, of which there
# are two digits. Arguments: PROGRAM, CASE (path of the .prm file), EXPECTED (path
# of the .output file), NUMDIFF, DIRECTORY (to run in); with UPDATE=ON the
# .output file is written instead.
file(REMOVE_RECURSE ${DIRECTORY})
file(MAKE_DIRECTORY ${DIRECTORY})
execute_process(COMMAND ${PROGRAM} ${CASE} --output results
  WORKING_DIRECTORY ${DIRECTORY}
  OUTPUT_VARIABLE _out ERROR_VARIABLE _err RESULT_VARIABLE _status)
if(NOT _status EQUAL 0 OR NOT "${_err}" STREQUAL "")
  message(FATAL_ERROR "Exit status ${_status}\n${_out}${_err}")
endif()

# Progress is for the eyes, and the table at the end has nothing but times.
string(REGEX REPLACE "\n[^\n]* passed, [^\n]* to go[^\n]*" "" _out "${_out}")
string(REGEX REPLACE "\n\n\\+---.*" "\n" _out "${_out}")
string(REGEX REPLACE "wall time [0-9.]+ s" "wall time # s" _out "${_out}")
string(REGEX REPLACE "[+-]?[0-9][0-9.e-]* %" "# %" _out "${_out}")
string(REGEX REPLACE "(volume balance|of the wear rate) [0-9.e-]+" "\\1 #"
       _out "${_out}")

if(UPDATE)
  file(WRITE ${EXPECTED} "${_out}")
  return()
endif()
file(WRITE ${DIRECTORY}/printed "${_out}")
execute_process(COMMAND ${NUMDIFF} -r 2e-3 -s " \\t\\n(),;:" ${EXPECTED}
                        ${DIRECTORY}/printed
  OUTPUT_VARIABLE _difference ERROR_VARIABLE _difference
  RESULT_VARIABLE _status)
if(NOT _status EQUAL 0)
  message(FATAL_ERROR "${_difference}\nprinted:\n${_out}")
endif()
message("The printed summary is right.")
