# SPDX-License-Identifier: LGPL-2.1-or-later

cmake_policy(VERSION 3.22)

# Write tribody_version.h with the revision of the sources, at build time, so
# that a commit after the last configuration shows. The file is touched only
# when its content changes. Arguments: SOURCE_DIR, OUTPUT, VERSION.
set(_revision "unknown")
find_program(GIT_PROGRAM git)
if(GIT_PROGRAM AND EXISTS ${SOURCE_DIR}/.git)
  execute_process(COMMAND ${GIT_PROGRAM} describe --always --dirty --abbrev=12
    WORKING_DIRECTORY ${SOURCE_DIR}
    OUTPUT_VARIABLE _described OUTPUT_STRIP_TRAILING_WHITESPACE
    ERROR_QUIET RESULT_VARIABLE _status)
  if(_status EQUAL 0)
    set(_revision ${_described})
  endif()
endif()
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT
"#define TRIBODY_VERSION \"@VERSION@\"
#define TRIBODY_REVISION \"@_revision@\"
" @ONLY)
