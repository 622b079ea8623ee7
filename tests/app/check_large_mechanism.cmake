# SPDX-License-Identifier: LGPL-2.1-or-later
# --check of chains of pendulums, whose time must grow with their number and not
# with its third power, by which it took minutes: 1000 that hang from one end, and
# 300 with both ends held, of which each body starts 1 um off its place.
# Arguments: PROGRAM, DIRECTORY.
file(REMOVE_RECURSE ${DIRECTORY})
file(MAKE_DIRECTORY ${DIRECTORY})

# Sets _chain to a chain of _n bodies; of each but the first the joint has the
# body's number.
function(make_chain _n)
  math(EXPR _last "${_n} - 1")
  set(_bodies b0)
  set(_joints j0)
  set(_lines "")
  foreach(_i RANGE ${_last})
    if(_i EQUAL 0)
      set(_before ground.O)
    else()
      math(EXPR _k "${_i} - 1")
      set(_before b${_k}.B)
      string(APPEND _bodies ", b${_i}")
      string(APPEND _joints ", j${_i}")
    endif()
    string(APPEND _lines
      "subsection Body b${_i}\nset Mass = 1 kg\nset Moment of inertia = 0.1 kg m^2\n"
      "set Markers = A: -0.5 m, 0 m; B: 0.5 m, 0 m\n"
      "set Initial position = ${_i}.5 m, 0 m\nend\n"
      "subsection Joint j${_i}\nset Pin marker = ${_before}\n"
      "set Bushing marker = b${_i}.A\nend\n")
  endforeach()
  string(CONCAT _chain
    "set Cycles = 0\nset Bodies = ${_bodies}\nset Joints = ${_joints}\n"
    "subsection Ground\nset Markers = O: 0 m, 0 m\nend\n${_lines}"
    "subsection Dynamics\nset Cycle duration = 0.1 s\nend\n")
  set(_chain "${_chain}" PARENT_SCOPE)
endfunction()

function(run _name _expected _status_expected)
  string(TIMESTAMP _start %s)
  execute_process(COMMAND ${PROGRAM} ${_name}.prm --check --output none
    WORKING_DIRECTORY ${DIRECTORY} TIMEOUT 60
    OUTPUT_VARIABLE _out ERROR_VARIABLE _err RESULT_VARIABLE _status)
  string(TIMESTAMP _end %s)
  math(EXPR _seconds "${_end} - ${_start}")
  message("${_name}: ${_seconds} s")
  if(NOT "${_status}" STREQUAL "${_status_expected}" OR
     NOT "${_out}${_err}" MATCHES "${_expected}")
    message(FATAL_ERROR "${_name}: status ${_status}\n${_out}${_err}")
  endif()
endfunction()

make_chain(1000)
file(WRITE ${DIRECTORY}/hanging.prm "${_chain}")
run(hanging "1000 bodies, 1000 joints, 1000 degrees of freedom" 0)

# Assembling that one still takes 54 s with 1000 bodies, so here are 300.
make_chain(300)
string(REPLACE ".5 m, 0 m" ".500001 m, 0 m" _chain "${_chain}")
string(REPLACE "set Joints = j0" "set Joints = end, j0" _chain "${_chain}")
file(WRITE ${DIRECTORY}/held.prm "${_chain}
subsection Ground
  set Markers = O: 0 m, 0 m; P: 297 m, 1 m
end
subsection Joint end
  set Pin marker     = ground.P
  set Bushing marker = b299.B
end
")
run(held "300 bodies, 301 joints, 298 degrees of freedom" 0)
