# Writes the headers of public_headers.txt, and the headers that they include, to OUT/brdf, under the paths
# for users: `#include "ROOM/NAME.h"` becomes `#include "brdf/ROOM/NAME.h"`. tools/site runs this file, too.
cmake_minimum_required(VERSION 3.25)
cmake_path(GET CMAKE_CURRENT_LIST_DIR PARENT_PATH SOURCE)
file(STRINGS ${CMAKE_CURRENT_LIST_DIR}/public_headers.txt entries REGEX "^[^#]")
list(TRANSFORM entries REPLACE "/.*" "" OUTPUT_VARIABLE rooms)
list(JOIN rooms "|" rooms)
while(entries)
  list(POP_FRONT entries header)
  if(NOT header IN_LIST done)
    list(APPEND done ${header})
    file(READ ${SOURCE}/${header} text)
    string(REGEX MATCHALL "#include \"(${rooms})/[^\"]+\"" includes "${text}")
    list(TRANSFORM includes REPLACE "#include \"(.*)\"" "\\1")
    list(APPEND entries ${includes})
    string(REGEX REPLACE "#include \"(${rooms})/" "#include \"brdf/\\1/" text "${text}")
    file(CONFIGURE OUTPUT ${OUT}/brdf/${header} CONTENT "${text}" @ONLY)  # an unchanged header keeps its time
  endif()
endwhile()
file(GLOB_RECURSE found RELATIVE ${OUT}/brdf ${OUT}/brdf/*.h)
list(REMOVE_ITEM found ${done})
list(TRANSFORM found PREPEND ${OUT}/brdf/)
file(REMOVE ${OUT}/none ${found})  # headers that are no longer public
