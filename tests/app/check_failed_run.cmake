# SPDX-License-Identifier: LGPL-2.1-or-later
# Run the program on a case that must fail on its way with status 1. It must name
# joint, depth and cell on stderr, and the results so far must be there. Arguments:
# PROGRAM, CASE (path of the .prm file), DIRECTORY (to run in).
get_filename_component(_name ${CASE} NAME_WE)
file(REMOVE_RECURSE ${DIRECTORY}/${_name})
execute_process(COMMAND ${PROGRAM} ${CASE} --output ${DIRECTORY}/${_name}
  OUTPUT_VARIABLE _stdout ERROR_VARIABLE _stderr RESULT_VARIABLE _status)
if(NOT _status EQUAL 1)
  message(FATAL_ERROR "${_name}: exit status ${_status}, should be 1.\n"
                      "${_stdout}${_stderr}")
endif()
if(NOT _stderr MATCHES "Bushing crank_pin: with a wear depth of up to 0\\.[0-9]+ mm the mesh turns inside out in the cell around \\(.*\\) mm")
  message(FATAL_ERROR "${_name}: the message is\n${_stderr}")
endif()
foreach(_file history.csv summary.json crank_pin/profile_0001.csv
        crank_pin/duty_cycle_0001.csv crank_pin/bushing_0001.vtu)
  if(NOT EXISTS ${DIRECTORY}/${_name}/${_file})
    message(FATAL_ERROR "${_name}: ${_file} is missing.")
  endif()
endforeach()
file(READ ${DIRECTORY}/${_name}/summary.json _summary)
string(JSON _status GET "${_summary}" status)
string(JSON _depth GET "${_summary}" joints crank_pin bushing max_wear_depth_m)
if(NOT _status STREQUAL "failed" OR NOT _depth GREATER 1e-4)
  message(FATAL_ERROR "${_name}: the summary says ${_status}, ${_depth} m")
endif()
message("${_name}: exit status 1, the right message, the results kept.")
