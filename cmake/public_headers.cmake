# cmake -D SOURCE=tree -D OUT=folder -D ROOMS=rooms -D ENTRIES=headers -P public_headers.cmake: writes these headers, and those
# that they include, as OUT/brdf/ROOM/NAME.h; `#include "ROOM/NAME.h"` becomes `#include "brdf/ROOM/NAME.h"`.
cmake_minimum_required(VERSION 3.25)
list(JOIN ROOMS "|" rooms)
while(ENTRIES)
  list(POP_FRONT ENTRIES header)
  if(NOT header IN_LIST done)
    list(APPEND done ${header})
    file(READ ${SOURCE}/${header} text)
    string(REGEX MATCHALL "#include \"(${rooms})/[^\"]+\"" includes "${text}")
    list(TRANSFORM includes REPLACE "#include \"(.*)\"" "\\1")
    list(APPEND ENTRIES ${includes})
    string(REGEX REPLACE "#include \"(${rooms})/" "#include \"brdf/\\1/" text "${text}")
    file(CONFIGURE OUTPUT ${OUT}/brdf/${header} CONTENT "${text}" @ONLY)  # an unchanged header keeps its time
  endif()
endwhile()
file(GLOB_RECURSE found RELATIVE ${OUT}/brdf ${OUT}/brdf/*.h)
list(REMOVE_ITEM found ${done})
list(TRANSFORM found PREPEND ${OUT}/brdf/)
file(REMOVE ${OUT}/none ${found})  # headers that are no longer public
