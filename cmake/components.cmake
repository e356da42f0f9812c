# The installed libraries and the names under which projects link them: brdf::core, brdf::io, brdf::sheet, brdf::measured, brdf::fit,
# brdf::validate. Each is a component of find_package(brdf) with its own set of targets and .pc file.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(BRDF_SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})  # until 1.0 a minor version may change the interface
set(BRDF_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/brdf)
set(BRDF_MODULE_DIR lib/python3/dist-packages/brdf)  # in the prefix: the path that Debian's interpreter searches in /usr
# A program finds the project's shared libraries relative to itself, so that the prefix can be moved.
if(BUILD_SHARED_LIBS)
  file(RELATIVE_PATH to_libraries ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})
  set(CMAKE_INSTALL_RPATH $ORIGIN $ORIGIN/${to_libraries})
endif()

# Headers of the rooms above libbrdf under the paths for users, brdf/ROOM/NAME.h, from the list in public_headers.txt.
set(BRDF_PUBLIC_HEADERS ${PROJECT_BINARY_DIR}/public)
set(script ${PROJECT_SOURCE_DIR}/cmake/public_headers.cmake)
list(TRANSFORM BRDF_INSTALLED_ROOMS REPLACE "(.+)" "${PROJECT_SOURCE_DIR}/\\1/*.h" OUTPUT_VARIABLE patterns)
file(GLOB_RECURSE headers CONFIGURE_DEPENDS ${patterns})
add_custom_command(OUTPUT ${BRDF_PUBLIC_HEADERS}.stamp
                   COMMAND ${CMAKE_COMMAND} -D OUT=${BRDF_PUBLIC_HEADERS} -P ${script}
                   COMMAND ${CMAKE_COMMAND} -E touch ${BRDF_PUBLIC_HEADERS}.stamp
                   DEPENDS ${headers} ${script} ${PROJECT_SOURCE_DIR}/cmake/public_headers.txt VERBATIM)
add_custom_target(brdf_public_headers ALL DEPENDS ${BRDF_PUBLIC_HEADERS}.stamp)

# brdf_component(TARGET NAME [REQUIRES names] [PC requirements] [PC_LIBS flags]): exports the target as brdf::NAME.
# REQUIRES: components of this project. PC: pkg-config modules; PC_LIBS: linker flags that a static library needs.
function(brdf_component target name)
  cmake_parse_arguments(C "" "" "REQUIRES;PC;PC_LIBS" ${ARGN})
  set_property(GLOBAL APPEND PROPERTY BRDF_COMPONENTS ${name})
  set_property(GLOBAL APPEND_STRING PROPERTY BRDF_NEEDED "set(brdf_needed_by_${name} core ${C_REQUIRES} ${name})\n")
  add_library(brdf::${name} ALIAS ${target})
  string(REPLACE "brdf_core" "brdf" PC_FILE brdf_${name})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name} OUTPUT_NAME ${PC_FILE} VERSION ${PROJECT_VERSION} SOVERSION ${BRDF_SOVERSION})
  target_compile_features(${target} PUBLIC cxx_std_20)
  if(BUILD_SHARED_LIBS)
    # Symbols outside namespace brdf are local.
    configure_file(${PROJECT_SOURCE_DIR}/cmake/brdf.map.in ${PROJECT_BINARY_DIR}/brdf.map @ONLY)
    target_link_options(${target} PRIVATE -Wl,--version-script=${PROJECT_BINARY_DIR}/brdf.map -Wl,--no-undefined)
    set_property(TARGET ${target} APPEND PROPERTY LINK_DEPENDS ${PROJECT_BINARY_DIR}/brdf.map)
    list(FILTER C_PC INCLUDE REGEX "^nlohmann_json$")  # users of a shared library do not need the others
    set(C_PC_LIBS "")
  endif()
  if(NOT name STREQUAL core)
    add_dependencies(${target} brdf_public_headers)
    if(NOT PROJECT_IS_TOP_LEVEL)
      target_include_directories(${target} INTERFACE $<BUILD_INTERFACE:${BRDF_PUBLIC_HEADERS}>)
    endif()
  endif()
  target_include_directories(${target} INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  if(NOT BRDF_INSTALL)
    return()
  endif()
  install(TARGETS ${target} EXPORT brdf_${name}
          LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT libraries NAMELINK_COMPONENT development
          ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
  install(EXPORT brdf_${name} NAMESPACE brdf:: DESTINATION ${BRDF_CMAKE_DIR} FILE brdf-${name}.cmake COMPONENT development)
  # The prefix is relative to the .pc file, which contains no absolute path.
  string(REGEX REPLACE "[^/]+" ".." up ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
  set(PC_PREFIX "\${pcfiledir}/${up}")
  string(REPLACE "_" "-" PC_NAME ${PC_FILE})
  list(TRANSFORM C_REQUIRES PREPEND "brdf-")
  list(JOIN C_PC_LIBS " " PC_LIBS)
  list(JOIN C_REQUIRES ", " PC_REQUIRES)
  list(APPEND PC_REQUIRES ${C_PC})
  list(JOIN PC_REQUIRES ", " PC_REQUIRES)
  string(REPLACE "brdf-core" "brdf" PC_REQUIRES "${PC_REQUIRES}")
  configure_file(${PROJECT_SOURCE_DIR}/cmake/brdf.pc.in ${PROJECT_BINARY_DIR}/pkgconfig/${PC_NAME}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/pkgconfig/${PC_NAME}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)
endfunction()

# The files that find_package(brdf) reads, and the headers.
function(brdf_install_development)
  get_property(BRDF_COMPONENTS GLOBAL PROPERTY BRDF_COMPONENTS)
  get_property(BRDF_NEEDED GLOBAL PROPERTY BRDF_NEEDED)
  set(files ${PROJECT_BINARY_DIR}/brdfConfig.cmake ${PROJECT_BINARY_DIR}/brdfConfigVersion.cmake)
  list(GET files 0 config)
  configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/brdfConfig.cmake.in ${config}
                                INSTALL_DESTINATION ${BRDF_CMAKE_DIR} NO_SET_AND_CHECK_MACRO)
  write_basic_package_version_file(${PROJECT_BINARY_DIR}/brdfConfigVersion.cmake COMPATIBILITY SameMinorVersion)
  install(FILES ${files} DESTINATION ${BRDF_CMAKE_DIR} COMPONENT development)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/libbrdf/brdf ${PROJECT_BINARY_DIR}/libbrdf/generated/brdf ${BRDF_PUBLIC_HEADERS}/brdf
          DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development FILES_MATCHING PATTERN *.h)
endfunction()

# The program with its data: scenes, materials and example samples, schemas, and Chart.js for machines without it (separately,
# because a package depends on the Chart.js of its distribution); man pages and completions, written by the program.
function(brdf_install_program target)
  set(from ${PROJECT_SOURCE_DIR})
  set(made ${PROJECT_BINARY_DIR})
  set(share ${CMAKE_INSTALL_DATADIR})
  install(TARGETS ${target} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
  install(DIRECTORY ${from}/data/ ${from}/share/brdf/ DESTINATION ${share}/brdf COMPONENT program)
  file(GLOB schemas CONFIGURE_DEPENDS ${from}/docs/*.schema.json)
  install(FILES ${schemas} DESTINATION ${share}/brdf/schemas COMPONENT program)
  if(CHART_JS)
    install(FILES ${CHART_JS} DESTINATION ${share}/brdf COMPONENT chart_js)
  endif()
  configure_file(${from}/packaging/brdf_check.1.in ${made}/packaging/brdf_check.1 @ONLY)
  add_custom_command(OUTPUT ${made}/described.stamp
                     COMMAND ${from}/packaging/describe $<TARGET_FILE:${target}> ${made}/described ${made}/packaging/brdf_check.1
                     COMMAND ${CMAKE_COMMAND} -E touch ${made}/described.stamp
                     DEPENDS ${target} ${from}/packaging/describe ${made}/packaging/brdf_check.1 VERBATIM)
  add_custom_target(brdf_described ALL DEPENDS ${made}/described.stamp)
  install(DIRECTORY ${made}/described/man/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
  install(DIRECTORY ${made}/described/share/ DESTINATION ${share} COMPONENT program)
  if(TARGET brdf_viewer)
    configure_file(${from}/packaging/org.brdf.view.metainfo.xml.in ${made}/org.brdf.view.metainfo.xml @ONLY)
    install(FILES ${made}/org.brdf.view.metainfo.xml DESTINATION ${share}/metainfo COMPONENT program)
    install(FILES ${from}/packaging/org.brdf.view.desktop DESTINATION ${share}/applications COMPONENT program)
    install(FILES ${from}/packaging/org.brdf.view.svg DESTINATION ${share}/icons/hicolor/scalable/apps COMPONENT program)
  endif()
endfunction()
