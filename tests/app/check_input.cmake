# SPDX-License-Identifier: LGPL-2.1-or-later
# What the program does with texts, names, files and sizes of its input that no
# single bad parameter file shows. Arguments: PROGRAM, SOURCE (the checkout),
# DIRECTORY (to run in).
file(REMOVE_RECURSE ${DIRECTORY})
file(MAKE_DIRECTORY ${DIRECTORY}/elsewhere)
set(_yoke ${SOURCE}/prm/scotch_yoke.prm)
set(_quickstart ${SOURCE}/prm/quickstart.prm)

# run(STATUS arguments ...): what it says is left in _said.
function(run _expected)
  execute_process(COMMAND ${PROGRAM} ${ARGN} WORKING_DIRECTORY ${DIRECTORY}
    OUTPUT_VARIABLE _out ERROR_VARIABLE _err RESULT_VARIABLE _status TIMEOUT 100)
  if(NOT "${_status}" STREQUAL "${_expected}")
    message(FATAL_ERROR "${ARGN}: status ${_status}, should be ${_expected}\n"
                        "${_out}${_err}")
  endif()
  string(LENGTH "${_err}" _length)
  if(_length GREATER 1100)
    message(FATAL_ERROR "${ARGN}: a message of ${_length} bytes\n${_err}")
  endif()
  set(_said "${_out}${_err}" PARENT_SCOPE)
endfunction()

function(expect _regex)
  if(NOT _said MATCHES "${_regex}")
    message(FATAL_ERROR "${_regex}\nis not in\n${_said}")
  endif()
endfunction()

# Control characters in texts do not command the terminal; in --set there are
# none, as they would put lines of their own into parameters.prm.
string(ASCII 27 _escape)
file(WRITE ${DIRECTORY}/title.prm
  "include ${_yoke}\nset Title = ${_escape}[31mred\n")
run(0 title.prm --check --output none)
expect("^\\\\x1b\\[31mred\n")
run(2 ${_yoke} --output none --set "Title=a\nset Cycles = 3")
expect("line without control characters")
run(2 ${_yoke} --output none --set "Gravity=${_escape}[31m")
expect("x1b\\[31m")

# What was used can be used again, from anywhere; also what that run has used.
run(0 ${SOURCE}/tests/app/mesh_file.prm --output first)
run(0 first/parameters.prm --check --output none)
file(COPY ${SOURCE}/tests/app/ring.msh DESTINATION ${DIRECTORY})
run(0 ${SOURCE}/tests/app/mesh_file.prm --output second
  --set "Bushing crank_pin/Mesh/File=ring.msh")
file(RENAME ${DIRECTORY}/second ${DIRECTORY}/elsewhere/moved)
run(0 elsewhere/moved/parameters.prm --output third)
run(0 third/parameters.prm --check --output none)

# At most one output per cycle.
foreach(_extrapolation implicit constant)
  run(0 ${_quickstart} --output outputs_${_extrapolation} --set Cycles=3
    --set "Output/Number of outputs=50"
    --set "Wear/Extrapolation=${_extrapolation}")
  file(GLOB _profiles
    ${DIRECTORY}/outputs_${_extrapolation}/crank_pin/profile_*.csv)
  list(LENGTH _profiles _n_profiles)
  if(_n_profiles GREATER 4)
    message(FATAL_ERROR "${_extrapolation}: ${_n_profiles} profiles of 3 cycles")
  endif()
endforeach()

# What no machine holds is refused before anything is made of it.
run(2 ${_quickstart} --check --output none
  --set "Bushing crank_pin/Mesh/Bore cells=100000")
expect("Mesh/Bore cells: 100000 bore cells and 6 radial cells need about [0-9]+ GB")
run(2 ${_quickstart} --check --output none
  --set "Bushing crank_pin/Mesh/Bore cells=20000"
  --set "Bushing crank_pin/Mesh/Radial cells=10000")
expect("20000 bore cells and 10000 radial cells need about [0-9]+ GB")
run(2 ${_quickstart} --check --output none
  --set "Bushing crank_pin/Mesh/Sector refinements=8"
  --set "Bushing crank_pin/Mesh/Refined sector=0 deg, 350 deg"
  --set "Bushing crank_pin/Mesh/Bore cells=1000")
expect("1000 bore cells and 6 radial cells need about [0-9]+ GB")

# Another user's or no file at all, of whatever name.
string(REPEAT x 300 _long)
run(2 ${_long})
run(2 ${_yoke} --check --output none --set "Springs=${_long}")
run(2 ${_yoke} --check --output none --set "Body ${_long}/Mass=1 kg")

if(EXISTS ${DIRECTORY}/none)
  message(FATAL_ERROR "A check or a refusal has made a directory.")
endif()
message("Texts, names, files and sizes are dealt with.")
