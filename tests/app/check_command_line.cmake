# SPDX-License-Identifier: LGPL-2.1-or-later
# Check what the program does without running a case: --version, --check and
# --print-parameters. Arguments: PROGRAM, CASE (a .prm file that is in order),
# DIRECTORY (to run in).
file(REMOVE_RECURSE ${DIRECTORY})
file(MAKE_DIRECTORY ${DIRECTORY})

# Runs the program; it must end with status 0 and say nothing on stderr. What it
# writes to the screen is left in _stdout.
function(run)
  execute_process(COMMAND ${PROGRAM} ${ARGN} WORKING_DIRECTORY ${DIRECTORY}
    OUTPUT_VARIABLE _out ERROR_VARIABLE _err RESULT_VARIABLE _status)
  if(NOT _status EQUAL 0 OR NOT "${_err}" STREQUAL "")
    message(FATAL_ERROR "${ARGN}: exit status ${_status}\n${_out}${_err}")
  endif()
  set(_stdout "${_out}" PARENT_SCOPE)
endfunction()

function(expect_match _regex)
  if(NOT _stdout MATCHES "${_regex}")
    message(FATAL_ERROR "${_regex}\nis not in\n${_stdout}")
  endif()
endfunction()

function(expect_files)
  file(GLOB_RECURSE _files RELATIVE ${DIRECTORY} LIST_DIRECTORIES true
       ${DIRECTORY}/*)
  if(NOT "${_files}" STREQUAL "${ARGN}")
    message(FATAL_ERROR "There are the files '${_files}', not '${ARGN}'.")
  endif()
endfunction()

set(_number "[0-9]+\\.[0-9]+\\.[0-9]+")
run(--version)
expect_match("^tribody ${_number} \\([0-9a-z-]+\\), deal\\.II ${_number}[^,\n]*, Trilinos ${_number}, SUNDIALS ${_number}\n$")

# One line for the title, the memory, the mechanism and each bushing, and the verdict.
run(--check ${CASE} --output results)
expect_match("^[^\n]+\nMemory: about [0-9]+ MB [^\n]+\nMechanism: 3 bodies, 4 joints, 2 degrees of freedom\nBushing crank_pin: 120 bore nodes, [^\n]+\nTime: about [0-9.]+ s \\(the first cycle [0-9.]+ s, a wear step [0-9.]+ s, of which the motion [0-9.]+ s; about [0-9]+ steps\\)\nThe file is in order; nothing was written\\.\n$")
expect_files()

# The template is a parameter file: the program takes it back, once the names
# that it leaves open say what turns and what is pulled.
run(--print-parameters)
file(WRITE ${DIRECTORY}/template.prm "${_stdout}")
run(--check template.prm --output results
  --set "Joint joint/Pin marker=body.O"
  --set "Spring spring/First marker=body.O"
  --set "Rotational spring rotational_spring/Body=body"
  --set "Driver driver/Body=body"
  --set "Driver driver/Speed=60 rpm"
  --set "Force force/Marker=body.O"
  --set "Torque torque/Body=body"
  --set "Load case load_case/Cycles=1")
expect_match("\nMechanism: 1 body, 1 joint, 0 degrees of freedom\nLoad case load_case: 100 % of the cycles, 1 s each\nTime: about [0-9.e-]+ s \\(the motion\\)\nThe file is in order; nothing was written\\.\n$")
expect_files(template.prm)

# Each parameter of the template is explained: a comment stands above it.
file(STRINGS ${DIRECTORY}/template.prm _lines)
set(_before "")
set(_n_parameters 0)
foreach(_line IN LISTS _lines)
  if(_line MATCHES "^ *set ")
    math(EXPR _n_parameters "${_n_parameters} + 1")
    if(NOT _before MATCHES "^ *# ")
      message(FATAL_ERROR "There is no comment above '${_line}'")
    endif()
  endif()
  set(_before "${_line}")
endforeach()
if(_n_parameters LESS 100)
  message(FATAL_ERROR "The template has ${_n_parameters} parameters only.")
endif()
message("--version, --check and --print-parameters are right.")
