# SPDX-License-Identifier: LGPL-2.1-or-later
# tribody_setup_target(TARGET): flags that every target of ours shares.
function(tribody_setup_target _target)
  deal_ii_setup_target(${_target})
  target_include_directories(${_target} PUBLIC ${PROJECT_SOURCE_DIR}/include)
  # Libraries that are not ours are not ours to warn about.
  target_include_directories(${_target} SYSTEM PUBLIC ${EIGEN3_INCLUDE_DIRS})
  # Debian's deal.II compiles with -g, which takes a quarter of the time and
  # most of the disk.
  target_compile_options(${_target} PRIVATE -Wall -Wextra -Wshadow=local
                         $<$<CONFIG:Release>:-g0>)
  if(TRIBODY_WERROR)
    target_compile_options(${_target} PRIVATE -Werror)
  endif()
endfunction()

# tribody_module(FOLDER SOURCES a.cc b.cc ... DEPENDS base multibody/joints ...)
#
# One static library per folder of source/, tribody_ and its path with
# underscores: tribody_multibody_joints. DEPENDS lists the folders that it may
# include; tests/style checks the include graph itself.
function(tribody_module _folder)
  cmake_parse_arguments(_module "" "" "SOURCES;DEPENDS;LIBRARIES" ${ARGN})
  string(REPLACE "/" "_" _name ${_folder})
  add_library(tribody_${_name} STATIC ${_module_SOURCES})
  tribody_setup_target(tribody_${_name})
  # deal.II's headers cost more than our sources: read once for several files.
  set_target_properties(tribody_${_name} PROPERTIES
                        UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 6)
  list(TRANSFORM _module_DEPENDS REPLACE "/" "_")
  list(TRANSFORM _module_DEPENDS PREPEND tribody_)
  # The plain signature: deal_ii_setup_target uses it, and CMake allows one.
  target_link_libraries(tribody_${_name} ${_module_DEPENDS}
                        ${_module_LIBRARIES})
endfunction()
