# What `cmake --install` puts where: three libraries with their headers for a user of the package, who
# needs Eigen alone; a shared library with a header of C, which needs nothing; cables for a user's own Bullet or ODE,
# who needs not even that; the program; the plug-ins (see tautline_engine_module). The components become
# packages in TautlinePackages.cmake; what names none belongs to the program.
include(CMakePackageConfigHelpers)

set(TAUTLINE_INSTALL_ENGINEDIR ${CMAKE_INSTALL_LIBDIR}/tautline/engines)
set(TAUTLINE_INSTALL_CMAKEDIR ${CMAKE_INSTALL_LIBDIR}/cmake/tautline)

install(TARGETS tautline_analytic tautline_interface tautline_engine
  EXPORT tautlineTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
install(TARGETS tautline_bullet_cable tautline_ode_cable EXPORT tautlineCableTargets)
set(cases_headers "")
if(TARGET tautline_cases)
  install(TARGETS tautline_cases
    EXPORT tautlineCasesTargets
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
  set(cases_headers bench/cases/include/)
endif()
install(DIRECTORY
  ${cases_headers} analytic/include/ engines/interface/include/ engines/adapter/include/ engines/cables/include/
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development
  FILES_MATCHING PATTERN "*.hpp" PATTERN "*.h")
if(TARGET tautline_c)
  install(TARGETS tautline_c
    EXPORT tautlineCTargets
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
      COMPONENT library
      NAMELINK_COMPONENT development)
  install(FILES languages/c/include/tautline/tautline.h
    DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/tautline COMPONENT development)
  # relative to the file itself, so that the tree may be moved
  cmake_path(RELATIVE_PATH CMAKE_INSTALL_PREFIX
    BASE_DIRECTORY "${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig" OUTPUT_VARIABLE up)
  set(TAUTLINE_PC_PREFIX "\${pcfiledir}/${up}")
  configure_file(languages/c/tautline.pc.in "${PROJECT_BINARY_DIR}/generated/tautline.pc" @ONLY)
  install(FILES "${PROJECT_BINARY_DIR}/generated/tautline.pc"
    DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)
  # `man tautline_solve` finds the page of all functions
  set(manual "${PROJECT_BINARY_DIR}/generated/man3")
  file(COPY languages/c/tautline.3 DESTINATION "${manual}")
  file(STRINGS languages/c/include/tautline/tautline.h declarations REGEX "^TAUTLINE_API ")
  foreach(declaration IN LISTS declarations)
    string(REGEX MATCH "tautline_[a-z_]+\\(" name "${declaration}")
    string(REPLACE "(" "" name "${name}")
    file(WRITE "${manual}/${name}.3" ".so man3/tautline.3\n")
  endforeach()
  install(DIRECTORY "${manual}/" DESTINATION ${CMAKE_INSTALL_MANDIR}/man3 COMPONENT development)
endif()
if(TARGET tautline)
  install(TARGETS tautline RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  install(FILES bench/gate/problems.toml bench/gate/problems.schema.json
    DESTINATION ${CMAKE_INSTALL_DATADIR}/tautline)
  # manual pages and shell completion, which the program has written
  install(DIRECTORY "${PROJECT_BINARY_DIR}/bench/share/" DESTINATION ${CMAKE_INSTALL_DATADIR})
endif()
# Debian's packages have a file `copyright` of their own in place of the licence
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT licence)
install(FILES THIRD_PARTY.md CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR})
# the pages, with links that lead to what is installed, and the site that scripts/site makes of them
find_program(TAUTLINE_PYTHON python3)
if(TAUTLINE_PYTHON)
  set(documents "${PROJECT_BINARY_DIR}/documents")
  add_custom_command(OUTPUT "${documents}/docs/README.md"
    COMMAND "${CMAKE_COMMAND}" -E rm -rf "${documents}"  # pages of another name
    COMMAND "${TAUTLINE_PYTHON}" "${PROJECT_SOURCE_DIR}/scripts/site" --installed "${documents}"
      --depfile "${PROJECT_BINARY_DIR}/generated/documents.d"
    DEPFILE "${PROJECT_BINARY_DIR}/generated/documents.d"
    DEPENDS scripts/site scripts/links.py
    COMMENT "Writing the documents"
    VERBATIM)
  add_custom_target(tautline_documents ALL DEPENDS "${documents}/docs/README.md")
  install(DIRECTORY "${documents}/" DESTINATION ${CMAKE_INSTALL_DOCDIR})
else()
  message(STATUS "documents: left out of what is installed (no python3)")
endif()
# the protocol and its kits, for engines in a process of their own; its page is among the documents
install(DIRECTORY engines/protocol/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/protocol
  PATTERN __pycache__ EXCLUDE PATTERN build EXCLUDE PATTERN node_modules EXCLUDE
  REGEX "protocol/README.md$" EXCLUDE)
# test vectors with their readers, to copy; their page is among the documents
install(DIRECTORY tests/vectors/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/vectors
  PATTERN .clang-format EXCLUDE PATTERN __pycache__ EXCLUDE REGEX "vectors/README.md$" EXCLUDE)
# projects of their own, to copy: each finds this tree with find_package(tautline)
foreach(example IN ITEMS own_engine bullet_crane ode_crane)
  install(DIRECTORY engines/examples/${example} DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples
    COMPONENT development)
endforeach()

configure_package_config_file(
  cmake/tautlineConfig.cmake.in "${PROJECT_BINARY_DIR}/generated/tautlineConfig.cmake"
  INSTALL_DESTINATION ${TAUTLINE_INSTALL_CMAKEDIR}
  PATH_VARS TAUTLINE_INSTALL_ENGINEDIR)
# before 1.0 a minor version may break what a user wrote
write_basic_package_version_file("${PROJECT_BINARY_DIR}/generated/tautlineConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
set(exports tautlineTargets tautlineCableTargets)
if(TARGET tautline_cases)
  list(APPEND exports tautlineCasesTargets)
endif()
if(TARGET tautline_c)
  list(APPEND exports tautlineCTargets)
endif()
foreach(targets IN LISTS exports)
  install(EXPORT ${targets} NAMESPACE tautline:: DESTINATION ${TAUTLINE_INSTALL_CMAKEDIR}
    COMPONENT development)
endforeach()
install(FILES
  "${PROJECT_BINARY_DIR}/generated/tautlineConfig.cmake"
  "${PROJECT_BINARY_DIR}/generated/tautlineConfigVersion.cmake"
  DESTINATION ${TAUTLINE_INSTALL_CMAKEDIR} COMPONENT development)
