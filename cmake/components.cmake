# The installed libraries. Each is a component of find_package(brdf) with its own targets and .pc file.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(BRDF_SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})  # 0.2 may change interfaces
set(BRDF_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/brdf)
set(BRDF_MODULE_DIR lib/python3/dist-packages/brdf)  # Debian's interpreter searches this path of /usr
if(BUILD_SHARED_LIBS)
  file(RELATIVE_PATH to_libraries ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})
  set(CMAKE_INSTALL_RPATH $ORIGIN $ORIGIN/${to_libraries})  # so that the prefix can be moved
endif()
set(OUT ${PROJECT_BINARY_DIR}/public)
include(cmake/public_headers.cmake)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${done} cmake/public_headers.txt)
set(headers_for_others $<$<NOT:$<BOOL:${PROJECT_IS_TOP_LEVEL}>>:${OUT}>)  # the project around this one
# brdf_component(TARGET NAME [REQUIRES components] [PACKAGES of CMake] [PC modules of pkg-config] [PC_LIBS
# flags of static libraries]): exports the target as brdf::NAME, with all that its users need.
function(brdf_component target name)
  cmake_parse_arguments(C "" "" "REQUIRES;PACKAGES;PC;PC_LIBS" ${ARGN})
  add_library(brdf::${name} ALIAS ${target})
  string(REPLACE "brdf_core" "brdf" PC_FILE brdf_${name})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name} OUTPUT_NAME ${PC_FILE}
                        VERSION ${PROJECT_VERSION} SOVERSION ${BRDF_SOVERSION})
  target_compile_features(${target} PUBLIC cxx_std_20)
  if(BUILD_SHARED_LIBS)
    set(map ${PROJECT_BINARY_DIR}/brdf.map)
    configure_file(${PROJECT_SOURCE_DIR}/cmake/brdf.map.in ${map} @ONLY)  # others' symbols are local
    target_link_options(${target} PRIVATE -Wl,--version-script=${map} -Wl,--no-undefined)
    list(FILTER C_PACKAGES INCLUDE REGEX "^(Threads|nlohmann_json)$")
    list(FILTER C_PC INCLUDE REGEX "^nlohmann_json$")
    set(C_PC_LIBS "")
  endif()
  set_property(GLOBAL APPEND PROPERTY BRDF_COMPONENTS ${name})
  set_property(GLOBAL APPEND_STRING PROPERTY BRDF_NEEDS "set(brdf_packages_of_${name} ${C_PACKAGES})
set(brdf_needed_by_${name} core ${C_REQUIRES} ${name})\n")
  target_include_directories(${target} INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
                             $<BUILD_INTERFACE:${headers_for_others}>)
  if(BRDF_INSTALL)
    install(TARGETS ${target} EXPORT brdf_${name} ARCHIVE COMPONENT development
            LIBRARY COMPONENT libraries NAMELINK_COMPONENT development)
    install(EXPORT brdf_${name} NAMESPACE brdf:: DESTINATION ${BRDF_CMAKE_DIR} FILE brdf-${name}.cmake
            COMPONENT development)
    string(REGEX REPLACE "[^/]+" ".." PC_UP ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
    string(REPLACE "_" "-" PC_NAME ${PC_FILE})
    list(TRANSFORM C_REQUIRES PREPEND "brdf-")
    string(JOIN ", " PC_REQUIRES ${C_REQUIRES} ${C_PC})
    string(REPLACE "brdf-core" "brdf" PC_REQUIRES "${PC_REQUIRES}")
    string(JOIN " " PC_LIBS ${C_PC_LIBS})
    set(pc ${PROJECT_BINARY_DIR}/pkgconfig/${PC_NAME}.pc)
    configure_file(${PROJECT_SOURCE_DIR}/cmake/brdf.pc.in ${pc} @ONLY)
    install(FILES ${pc} DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)
  endif()
endfunction()
