# What is installed, and under which names others link it: brdf::core, brdf::io, brdf::sheet, brdf::fit, brdf::validate, each a
# component of find_package(brdf) with a set of targets and a .pc file of its own. `package.cmake` makes packages of it.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# Until 1.0 a minor version may change the interface.
set(BRDF_SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
set(BRDF_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/brdf)
# Of the Python module, in the prefix: where Debian's interpreter looks in /usr.
set(BRDF_MODULE_DIR lib/python3/dist-packages/brdf)

# A program finds shared libraries of ours beside itself, wherever the prefix is moved to.
if(BUILD_SHARED_LIBS)
  file(RELATIVE_PATH to_libraries ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})
  set(CMAKE_INSTALL_RPATH $ORIGIN $ORIGIN/${to_libraries})
endif()

# Headers of the rooms above libbrdf, as others include them: brdf/ROOM/NAME.h, with what they include of one another
# spelled so too. Made by public_headers.cmake of these and of all that they include.
set(BRDF_PUBLIC_HEADERS ${PROJECT_BINARY_DIR}/public)
set(BRDF_ENTRY_HEADERS
    io/samples/samples.h io/material/material_file.h io/material/material_json.h io/files/error.h io/csv/csv.h io/formats/merl.h io/formats/rgl.h io/formats/astm.h io/formats/zemax.h
    io/formats/exr_table.h io/material/glsl.h io/files/provenance.h io/samples/relative_scale.h
    measured/measured.h
    fit/fit.h fit/stepwise.h fit/file_batch.h fit/report/report.h fit/report/html.h
    sheet/data_sheet.h
    validate/form/checks.h validate/report/report.h)

function(brdf_public_headers)
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/io/*.h ${PROJECT_SOURCE_DIR}/measured/*.h
       ${PROJECT_SOURCE_DIR}/sheet/*.h ${PROJECT_SOURCE_DIR}/fit/*.h ${PROJECT_SOURCE_DIR}/validate/*.h)
  set(script ${PROJECT_SOURCE_DIR}/cmake/public_headers.cmake)
  set(stamp ${PROJECT_BINARY_DIR}/public_headers.stamp)
  add_custom_command(OUTPUT ${stamp}
                     COMMAND ${CMAKE_COMMAND} -D SOURCE=${PROJECT_SOURCE_DIR} -D OUT=${BRDF_PUBLIC_HEADERS}
                             "-DENTRIES=${BRDF_ENTRY_HEADERS}" -P ${script}
                     COMMAND ${CMAKE_COMMAND} -E touch ${stamp}
                     DEPENDS ${headers} ${script} VERBATIM)
  add_custom_target(brdf_public_headers ALL DEPENDS ${stamp})
endfunction()

# brdf_component(TARGET NAME [REQUIRES names] [PC requirements] [PC_LIBS flags]): exports the target as brdf::NAME.
# REQUIRES: components of ours. PC: pkg-config modules; PC_LIBS: linker flags of a static library's own needs.
function(brdf_component target name)
  cmake_parse_arguments(C "" "" "REQUIRES;PC;PC_LIBS" ${ARGN})
  add_library(brdf::${name} ALIAS ${target})
  set(file brdf_${name})
  if(name STREQUAL core)
    set(file brdf)
  endif()
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name} OUTPUT_NAME ${file} VERSION ${PROJECT_VERSION}
                        SOVERSION ${BRDF_SOVERSION})
  target_compile_features(${target} PUBLIC cxx_std_20)
  if(BUILD_SHARED_LIBS)
    # Calls inside a library stay as direct as in a static one; what is not of namespace brdf stays inside.
    set_target_properties(${target} PROPERTIES VISIBILITY_INLINES_HIDDEN ON)
    target_compile_options(${target} PRIVATE -fno-semantic-interposition)
    set(map ${PROJECT_BINARY_DIR}/brdf.map)
    configure_file(${PROJECT_SOURCE_DIR}/cmake/brdf.map.in ${map} @ONLY)
    target_link_options(${target} PRIVATE -Wl,--version-script=${map} -Wl,--no-undefined)
    set_property(TARGET ${target} APPEND PROPERTY LINK_DEPENDS ${map})
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
  install(EXPORT brdf_${name} NAMESPACE brdf:: DESTINATION ${BRDF_CMAKE_DIR} FILE brdf-${name}.cmake
          COMPONENT development)

  # prefix is where the .pc file is found: nothing in it is an absolute path.
  string(REGEX REPLACE "[^/]+" ".." up ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
  set(PC_PREFIX "\${pcfiledir}/${up}")
  string(REPLACE "_" "-" PC_NAME ${file})
  set(PC_FILE ${file})
  list(TRANSFORM C_REQUIRES PREPEND "brdf-" OUTPUT_VARIABLE requires)
  list(TRANSFORM requires REPLACE "^brdf-core$" "brdf")
  set(PC_LIBS "")
  if(BUILD_SHARED_LIBS)
    list(FILTER C_PC INCLUDE REGEX "^nlohmann_json$")  # the others are no business of a shared library's user
  else()
    list(JOIN C_PC_LIBS " " PC_LIBS)
  endif()
  list(APPEND requires ${C_PC})
  list(JOIN requires ", " PC_REQUIRES)
  configure_file(${PROJECT_SOURCE_DIR}/cmake/brdf.pc.in ${PROJECT_BINARY_DIR}/pkgconfig/${PC_NAME}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/pkgconfig/${PC_NAME}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
          COMPONENT development)
endfunction()

# What find_package(brdf) reads, and the headers.
function(brdf_install_development)
  set(BRDF_SHARED ${BUILD_SHARED_LIBS})
  configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/brdfConfig.cmake.in ${PROJECT_BINARY_DIR}/brdfConfig.cmake
                                INSTALL_DESTINATION ${BRDF_CMAKE_DIR} NO_SET_AND_CHECK_MACRO)
  write_basic_package_version_file(${PROJECT_BINARY_DIR}/brdfConfigVersion.cmake COMPATIBILITY SameMinorVersion)
  install(FILES ${PROJECT_BINARY_DIR}/brdfConfig.cmake ${PROJECT_BINARY_DIR}/brdfConfigVersion.cmake
          DESTINATION ${BRDF_CMAKE_DIR} COMPONENT development)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/libbrdf/brdf ${PROJECT_BINARY_DIR}/libbrdf/generated/brdf
                    ${BRDF_PUBLIC_HEADERS}/brdf
          DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development FILES_MATCHING PATTERN *.h)
endfunction()

# The program with its data: scenes, materials and samples to try, schemas, and Chart.js for a machine without it (apart,
# for a package names the one of its distribution).
function(brdf_install_program target)
  install(TARGETS ${target} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/data/ ${PROJECT_SOURCE_DIR}/share/brdf/
          DESTINATION ${CMAKE_INSTALL_DATADIR}/brdf COMPONENT program)
  file(GLOB schemas CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/docs/*.schema.json)
  install(FILES ${schemas} DESTINATION ${CMAKE_INSTALL_DATADIR}/brdf/schemas COMPONENT program)
  if(CHART_JS)
    install(FILES ${CHART_JS} DESTINATION ${CMAKE_INSTALL_DATADIR}/brdf COMPONENT chart_js)
  endif()

  # Man pages and completions, of the program's own words.
  set(described ${PROJECT_BINARY_DIR}/described)
  set(script ${PROJECT_SOURCE_DIR}/cmake/describe.cmake)
  set(page ${PROJECT_BINARY_DIR}/packaging/brdf_check.1)
  configure_file(${PROJECT_SOURCE_DIR}/packaging/brdf_check.1.in ${page} @ONLY)
  add_custom_command(OUTPUT ${described}.stamp
                     COMMAND ${CMAKE_COMMAND} -D PROGRAM=$<TARGET_FILE:${target}> -D OUT=${described} -D PAGE=${page} -P ${script}
                     COMMAND ${CMAKE_COMMAND} -E touch ${described}.stamp
                     DEPENDS ${target} ${script} ${page} VERBATIM)
  add_custom_target(brdf_described ALL DEPENDS ${described}.stamp)
  install(DIRECTORY ${described}/man/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
  install(DIRECTORY ${described}/bash/ DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
          COMPONENT program)
  install(DIRECTORY ${described}/zsh/ DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions COMPONENT program)

  if(TARGET brdf_viewer)
    set(name org.brdf.view)
    set(from ${PROJECT_SOURCE_DIR}/packaging)
    configure_file(${from}/${name}.metainfo.xml.in ${PROJECT_BINARY_DIR}/${name}.metainfo.xml @ONLY)
    install(FILES ${PROJECT_BINARY_DIR}/${name}.metainfo.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo
            COMPONENT program)
    install(FILES ${from}/${name}.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications COMPONENT program)
    install(FILES ${from}/${name}.svg DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps COMPONENT program)
  endif()
endfunction()
