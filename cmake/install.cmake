# The files that find_package(brdf) reads, and the headers. Include this file after all rooms.
get_property(BRDF_COMPONENTS GLOBAL PROPERTY BRDF_COMPONENTS)
get_property(BRDF_NEEDS GLOBAL PROPERTY BRDF_NEEDS)
set(from ${PROJECT_SOURCE_DIR})
set(made ${PROJECT_BINARY_DIR})
set(share ${CMAKE_INSTALL_DATADIR})
configure_package_config_file(${from}/cmake/brdfConfig.cmake.in ${made}/brdfConfig.cmake
                              INSTALL_DESTINATION ${BRDF_CMAKE_DIR} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${made}/brdfConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${made}/brdfConfig.cmake ${made}/brdfConfigVersion.cmake
        DESTINATION ${BRDF_CMAKE_DIR} COMPONENT development)
install(DIRECTORY ${from}/libbrdf/brdf ${made}/libbrdf/generated/brdf ${made}/public/brdf
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development FILES_MATCHING PATTERN *.h)
if(NOT BRDF_PROGRAM)
  return()
endif()
# The program with its data. Chart.js, for machines without it, is a part of its own, because a package
# depends on the Chart.js of its distribution. The program writes its man pages and completions.
install(TARGETS brdf brdf_check RUNTIME COMPONENT program)
install(DIRECTORY ${from}/data/ ${from}/share/brdf/ DESTINATION ${share}/brdf COMPONENT program)
file(GLOB schemas CONFIGURE_DEPENDS ${from}/docs/*.schema.json)
install(FILES ${schemas} DESTINATION ${share}/brdf/schemas COMPONENT program)
install(FILES $<$<BOOL:${CHART_JS}>:${CHART_JS}> DESTINATION ${share}/brdf COMPONENT chart_js)
set(page ${made}/packaging/brdf_check.1)
configure_file(${from}/packaging/brdf_check.1.in ${page} @ONLY)
add_custom_command(OUTPUT ${made}/described.stamp DEPENDS brdf ${from}/packaging/describe ${page} VERBATIM
                   COMMAND ${from}/packaging/describe $<TARGET_FILE:brdf> ${made}/described ${page}
                   COMMAND ${CMAKE_COMMAND} -E touch ${made}/described.stamp)
add_custom_target(brdf_described ALL DEPENDS ${made}/described.stamp)
install(DIRECTORY ${made}/described/man/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
install(DIRECTORY ${made}/described/share/ DESTINATION ${share} COMPONENT program)
if(TARGET brdf_viewer)
  set(view packaging/org.brdf.view)
  configure_file(${from}/${view}.metainfo.xml.in ${made}/org.brdf.view.metainfo.xml @ONLY)
  install(FILES ${made}/org.brdf.view.metainfo.xml DESTINATION ${share}/metainfo COMPONENT program)
  install(FILES ${from}/${view}.desktop DESTINATION ${share}/applications COMPONENT program)
  install(FILES ${from}/${view}.svg DESTINATION ${share}/icons/hicolor/scalable/apps COMPONENT program)
endif()
if(NOT BUILD_SHARED_LIBS)
  include(cmake/package.cmake)
endif()
