# Debian packages by `cpack`: brdf, libbrdf-dev and python3-brdf. Their fields are in packaging/*.control.
set(BRDF_MAINTAINER "brdf contributors <contributors@brdf.invalid>" CACHE STRING "Of the Debian packages")
set(CPACK_COMPONENTS_ALL program development)
if(TARGET brdf_python)
  list(APPEND CPACK_COMPONENTS_ALL python)
  math(EXPR next "${BRDF_PYTHON_MINOR} + 1")  # the extension is built for one version of the interpreter
  file(GLOB CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA ${from}/packaging/python3-brdf/*)
  install(TARGETS brdf_python LIBRARY DESTINATION ${BRDF_MODULE_DIR} COMPONENT python)
  install(DIRECTORY ${from}/python/brdf/ DESTINATION ${BRDF_MODULE_DIR} COMPONENT python
          FILES_MATCHING PATTERN *.* PATTERN __pycache__ EXCLUDE)
endif()
# Debian requires a copyright and a changelog of every package; they are not part of `cmake --install`.
configure_file(${from}/packaging/changelog.in ${made}/packaging/changelog @ONLY)
execute_process(COMMAND gzip -9nf ${made}/packaging/changelog)
foreach(component all ${CPACK_COMPONENTS_ALL})
  string(TOUPPER CPACK_DEBIAN_${component} field)
  string(REPLACE CPACK_DEBIAN_ALL CPACK field ${field})
  file(STRINGS ${from}/packaging/${component}.control rows)
  foreach(row IN LISTS rows)  # "NAME: value", continued by rows that begin with a blank
    string(CONFIGURE "${row}" row @ONLY)
    if(row MATCHES "^([A-Z_]+): (.*)")
      set(name ${field}_${CMAKE_MATCH_1})
      set(${name} "${CMAKE_MATCH_2}")
    else()
      string(REGEX REPLACE "^ " "\n" row "${row}")
      string(APPEND ${name} "${row}")
    endif()
  endforeach()
  if(NOT component STREQUAL all)
    install(FILES ${from}/packaging/copyright ${made}/packaging/changelog.gz
            DESTINATION share/doc/${${field}_PACKAGE_NAME} COMPONENT ${component} EXCLUDE_FROM_ALL)
  endif()
endforeach()
include(CPack)
