# Linked into every target: warnings, and the include root. The warnings that are off report sound code: clang
# unvectorised loops and omitted braces, GCC 12 impossible overlaps and copies in <string> and <regex>.
add_library(brdf_options INTERFACE)
target_include_directories(brdf_options INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_definitions(brdf_options INTERFACE BRDF_VERSION="${PROJECT_VERSION}"
                           $<$<NOT:${all_clones}>:BRDF_FEW_CLONES>)
set(gnu $<CXX_COMPILER_ID:GNU>)
set(page $<BOOL:${EMSCRIPTEN}>)  # fetched before it computes: its preset has -Oz
set(release $<AND:$<CONFIG:Release>,$<NOT:${page}>>)
set(sanitized $<BOOL:${BRDF_SANITIZED}>)
target_compile_options(
  brdf_options INTERFACE -Wall -Wextra -Wno-missing-field-initializers -fno-semantic-interposition
  $<${gnu}:-Wshadow;-Wno-restrict;-Wno-stringop-overflow;$<${sanitized}:-Wno-maybe-uninitialized>>
  $<$<CXX_COMPILER_ID:Clang>:-Wno-pass-failed;-Wno-missing-braces> $<$<BOOL:${BRDF_WERROR}>:-Werror>)
# brdf_require(PART RESULT needs...): sets RESULT to OFF, with a message, if a need is missing.
function(brdf_require part result)
  foreach(need IN LISTS ARGN)
    if(NOT (${need} OR TARGET ${need} OR EXISTS ${need}))
      string(APPEND missing " ${need}")
    endif()
  endforeach()
  if(missing)
    message(STATUS "brdf: without ${part} (missing:${missing})")
    set(${result} OFF PARENT_SCOPE)
  endif()
endfunction()
# brdf_program(NAME sources... LIBRARIES targets [DEFINE macros]): a program, if this build has its libraries.
function(brdf_program name)
  cmake_parse_arguments(P "" "" "LIBRARIES;DEFINE" ${ARGN})
  brdf_require(${name} P_LIBRARIES ${P_LIBRARIES})
  if(P_LIBRARIES)
    add_executable(${name} ${P_UNPARSED_ARGUMENTS})
    target_link_libraries(${name} PRIVATE brdf_options ${P_LIBRARIES})
    target_compile_definitions(${name} PRIVATE ${P_DEFINE})
  endif()
endfunction()
