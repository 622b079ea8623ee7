# SPDX-License-Identifier: LGPL-2.1-or-later
# Run the program on a bad parameter file and compare what it says on stderr
# with the .output file beside it. It must exit with status 2 and write nothing.
# Arguments: PROGRAM, CASE (path of the .prm file), DIRECTORY (to run in),
# optional ARGUMENTS; with UPDATE=ON the .output file is written instead.
get_filename_component(_source ${CASE} DIRECTORY)
get_filename_component(_name ${CASE} NAME_WE)

# Run beside the file, so that messages do not depend on where the tree is; the
# output directory is elsewhere.
file(REMOVE_RECURSE ${DIRECTORY}/${_name})
execute_process(
  COMMAND ${PROGRAM} ${_name}.prm --output ${DIRECTORY}/${_name} ${ARGUMENTS}
  WORKING_DIRECTORY ${_source}
  OUTPUT_VARIABLE _stdout ERROR_VARIABLE _stderr RESULT_VARIABLE _status)

if(NOT _status EQUAL 2)
  message(FATAL_ERROR "${_name}: exit status ${_status}, should be 2.\n"
                      "${_stdout}${_stderr}")
endif()
if(EXISTS ${DIRECTORY}/${_name})
  message(FATAL_ERROR "${_name}: wrote an output directory.")
endif()
if(UPDATE)
  file(WRITE ${_source}/${_name}.output "${_stderr}")
else()
  file(READ ${_source}/${_name}.output _expected)
  if(NOT _stderr STREQUAL _expected)
    message(FATAL_ERROR "${_name}: the message is\n${_stderr}\nand should be\n"
                        "${_expected}")
  endif()
endif()
message("${_name}: exit status 2 and the right message.")
