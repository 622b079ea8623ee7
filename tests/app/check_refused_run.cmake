# SPDX-License-Identifier: LGPL-2.1-or-later
# Run the program on a case whose premises do not hold. It must end with status 1,
# say on stderr what the .output file beside the case has, and write a summary that
# says "failed". Arguments: PROGRAM, CASE (path of the .prm file), DIRECTORY (to run
# in).
get_filename_component(_source ${CASE} DIRECTORY)
get_filename_component(_name ${CASE} NAME_WE)
file(REMOVE_RECURSE ${DIRECTORY}/${_name})
execute_process(COMMAND ${PROGRAM} ${CASE} --output ${DIRECTORY}/${_name}
  OUTPUT_VARIABLE _stdout ERROR_VARIABLE _stderr RESULT_VARIABLE _status)
if(NOT _status EQUAL 1)
  message(FATAL_ERROR "${_name}: exit status ${_status}, should be 1.\n"
                      "${_stdout}${_stderr}")
endif()
file(READ ${_source}/${_name}.output _expected)
string(FIND "${_stderr}" "${_expected}" _place)
if(_place EQUAL -1)
  message(FATAL_ERROR "${_name}: the message is\n${_stderr}")
endif()
file(READ ${DIRECTORY}/${_name}/summary.json _summary)
string(JSON _status GET "${_summary}" status)
if(NOT _status STREQUAL "failed")
  message(FATAL_ERROR "${_name}: the summary says ${_status}")
endif()
message("${_name}: exit status 1, the right message.")
