# Debian packages by `cpack` in the build folder: brdf, libbrdf-dev (static libraries: no interface is promised before 1.0)
# and, where the module is built, python3-brdf. Include after all rooms.
set(BRDF_MAINTAINER "brdf contributors <contributors@brdf.invalid>" CACHE STRING "Of the Debian packages")
mark_as_advanced(BRDF_MAINTAINER)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME brdf)
set(CPACK_PACKAGE_CONTACT ${BRDF_MAINTAINER})
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_COMPONENTS_ALL program development)
if(TARGET brdf_python)
  list(APPEND CPACK_COMPONENTS_ALL python)
endif()
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "models of surface reflection, fitted to measurements and judged")
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ
                                                WORLD_EXECUTE)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME brdf)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS "fonts-dejavu-core, libjs-chart.js")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "mesa-vulkan-drivers | vulkan-icd")
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "Fits analytic BRDFs to goniometric measurements, with intervals that hold and a
verdict, proves what the fitted material does (energy, reciprocity, numerical
limits), and shows it beside the measurements, checked against a ray-traced
reference.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libbrdf-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
    "libstdc++-12-dev | libstdc++-dev, libceres-dev, libopenexr-dev, libstb-dev, nlohmann-json3-dev")
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "Headers, static libraries, CMake and pkg-config files of brdf: the models of
surface reflection (core, standard library only), tables of samples and
materials (io), fits with intervals (fit), checks of what a model keeps
(validate).")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-brdf)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
if(TARGET brdf_python)
  # The extension is for one version of the interpreter.
  get_target_property(version brdf_python BRDF_PYTHON_VERSION)
  string(REGEX MATCH "[0-9]+$" next ${version})
  math(EXPR next "${next} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
      "python3 (>= ${version}), python3 (<< 3.${next}), python3-numpy, libjs-chart.js")
endif()
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA
    "${PROJECT_SOURCE_DIR}/packaging/python3-brdf/postinst;${PROJECT_SOURCE_DIR}/packaging/python3-brdf/prerm")
set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "brdf, python3-matplotlib, python3-pandas")
set(CPACK_DEBIAN_PYTHON_DESCRIPTION "The module brdf: tables of samples as numpy arrays, fits with intervals,
materials that are evaluated on arrays, albedo with an error bound, checks and
exports. The numbers are those of the program brdf.")

# The module: the extension beside the package's own files.
if(TARGET brdf_python)
  install(TARGETS brdf_python LIBRARY DESTINATION ${BRDF_MODULE_DIR} COMPONENT python)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/python/brdf/ DESTINATION ${BRDF_MODULE_DIR} COMPONENT python
          FILES_MATCHING PATTERN *.py PATTERN *.pyi PATTERN py.typed PATTERN *.json
          PATTERN __pycache__ EXCLUDE)
endif()

# What Debian asks of every package; no part of `cmake --install`.
configure_file(${PROJECT_SOURCE_DIR}/packaging/changelog.in ${PROJECT_BINARY_DIR}/packaging/changelog @ONLY)
execute_process(COMMAND gzip -9nf ${PROJECT_BINARY_DIR}/packaging/changelog)
foreach(pair program:brdf development:libbrdf-dev python:python3-brdf)
  string(REPLACE ":" ";" pair ${pair})
  list(GET pair 0 component)
  list(GET pair 1 package)
  if(component IN_LIST CPACK_COMPONENTS_ALL)
    install(FILES ${PROJECT_SOURCE_DIR}/packaging/copyright ${PROJECT_BINARY_DIR}/packaging/changelog.gz
            DESTINATION share/doc/${package} COMPONENT ${component} EXCLUDE_FROM_ALL)
  endif()
endforeach()
include(CPack)
