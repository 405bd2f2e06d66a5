# What `cpack` makes of the components of TautlineInstall.cmake (scripts/package builds and calls it): an
# archive of all, which runs where it is unpacked, and a Debian package of each:
#
#   tautline             the program with its exact engine
#   libtautline0         the exact solver as functions of C
#   tautline-dev         headers, libraries, cables, CMake package, examples
#   tautline-engine-...  the plug-ins of an engine, in either precision; they bring the engine
#   tautline-mpi         ensembles in several processes
set(CPACK_GENERATOR TGZ DEB)
set(CPACK_PACKAGE_VENDOR "tautline")
set(CPACK_PACKAGE_FILE_NAME "tautline-${PROJECT_VERSION}-${CMAKE_SYSTEM_NAME}-${CMAKE_SYSTEM_PROCESSOR}")
set(CPACK_PACKAGE_DIRECTORY "${PROJECT_BINARY_DIR}/packages")
set(CPACK_STRIP_FILES ON)
set(CPACK_PRE_BUILD_SCRIPTS "${PROJECT_SOURCE_DIR}/cmake/CompressManuals.cmake")
set(CPACK_VERBATIM_VARIABLES ON)

# no person answers at an address under .invalid (RFC 2606), and Debian asks for one
set(TAUTLINE_MAINTAINER "tautline developers <developers@tautline.invalid>")
set(TAUTLINE_DEBIAN_REVISION 1)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "${TAUTLINE_MAINTAINER}")
set(CPACK_DEBIAN_PACKAGE_RELEASE ${TAUTLINE_DEBIAN_REVISION})
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_COMPONENTS_ALL "")
# each package says itself what it is
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")

# what each Debian package has beside its files: the archive has these once, or not at all
function(tautline_debian_documents package component)
  set(folder "${PROJECT_BINARY_DIR}/generated/debian")
  string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)  # SOURCE_DATE_EPOCH where that is set
  configure_file(packaging/debian/changelog.in "${folder}/changelog" @ONLY)
  find_program(TAUTLINE_GZIP gzip)
  mark_as_advanced(TAUTLINE_GZIP)
  if(TAUTLINE_GZIP)
    execute_process(COMMAND "${TAUTLINE_GZIP}" -9nc "${folder}/changelog"
      OUTPUT_FILE "${folder}/changelog.Debian.gz" COMMAND_ERROR_IS_FATAL ANY)
    install(FILES "${folder}/changelog.Debian.gz" DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package}
      COMPONENT ${component} EXCLUDE_FROM_ALL)
  endif()
  install(FILES packaging/debian/copyright DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package}
    COMPONENT ${component} EXCLUDE_FROM_ALL)
endfunction()

# tautline_debian_package(<component> <package> <what it is> <lines of text...>)
macro(tautline_debian_package component package summary)
  string(TOUPPER ${component} variable)
  list(APPEND CPACK_COMPONENTS_ALL ${component})
  set(CPACK_DEBIAN_${variable}_PACKAGE_NAME ${package})
  set(lines "${summary}" ${ARGN})
  list(JOIN lines "\n" CPACK_DEBIAN_${variable}_DESCRIPTION)
  tautline_debian_documents(${package} ${component})
endmacro()

set(same_version "(= ${PROJECT_VERSION}-${TAUTLINE_DEBIAN_REVISION})")

set(recommended "")
set(suggested tautline-dev)
get_property(components GLOBAL PROPERTY TAUTLINE_ENGINE_COMPONENTS)
if(components)
  list(REMOVE_DUPLICATES components)
endif()
# what the program calls a missing engine is a name that apt knows
set(CPACK_DEBIAN_ENGINE_BULLET_PACKAGE_PROVIDES "tautline-engine-bullet64, tautline-engine-bullet32")
foreach(component IN LISTS components)
  string(REPLACE "engine_" "" engine ${component})
  set(package tautline-engine-${engine})
  string(TOUPPER ${component} variable)
  tautline_debian_package(${component} ${package} "plug-in of tautline for the physics engine ${engine}"
    "With it tautline runs its cases on this engine too. It brings the engine's"
    "library.")
  set(CPACK_DEBIAN_${variable}_PACKAGE_DEPENDS "tautline ${same_version}")
  # hundreds of MB are not brought unasked
  if(engine MATCHES "^(dart|simbody|siconos)$")
    list(APPEND suggested ${package})
  else()
    list(APPEND recommended ${package})
  endif()
endforeach()

if(TARGET tautline)
  tautline_debian_package(program tautline "exact rigid bodies on slack cables, and a bench of physics engines"
    "A slack cable that goes taut stops a body with an impact. tautline solves"
    "this motion exactly, and holds physics engines against the solution:"
    "positions, impacts, settling, energy and restitution, with the cause of each"
    "error. Engines are plug-ins, in packages of their own.")
  if(TARGET tautline-mpi)
    tautline_debian_package(mpi tautline-mpi "ensembles of tautline under mpirun"
      "With it the processes that mpirun or srun starts share the draws of"
      "\`tautline ensemble\`, on one machine or a cluster. The results are those of"
      "one process.")
    set(CPACK_DEBIAN_MPI_PACKAGE_DEPENDS "tautline ${same_version}")
    file(WRITE "${PROJECT_BINARY_DIR}/generated/debian/tautline-mpi"
      "# it calls MPI alone, whose library is linked against that of C\n"
      "tautline-mpi: library-not-linked-against-libc *\n")
    install(FILES "${PROJECT_BINARY_DIR}/generated/debian/tautline-mpi"
      DESTINATION ${CMAKE_INSTALL_DATADIR}/lintian/overrides COMPONENT mpi EXCLUDE_FROM_ALL)
    list(APPEND suggested tautline-mpi)
  endif()
  list(JOIN recommended ", " CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS)
  list(JOIN suggested ", " CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS)
endif()

tautline_debian_package(development tautline-dev "cables for Bullet and ODE, exact solver and engine interface"
  "Headers and static libraries: a cable for your own Bullet or ODE world whose"
  "restitution is right, the exact solver of tautline, a reader of its case"
  "files, and the interface of its engine plug-ins; with a CMake package and"
  "examples.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
# the cables need neither, the libraries do
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libeigen3-dev (>= 3.4)")
if(TARGET tautline_c)
  get_target_property(abi tautline_c SOVERSION)
  tautline_debian_package(library libtautline${abi} "exact motion of rigid bodies on slack cables, for C"
    "The exact solver of tautline as functions of C, which every language can"
    "call. The header and the manual page are in tautline-dev.")
  set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libs)
  # what programs that link it depend on, and the cache of the loader
  file(WRITE "${PROJECT_BINARY_DIR}/generated/debian/shlibs"
    "libtautline ${abi} libtautline${abi} (>= ${PROJECT_VERSION})\n")
  file(WRITE "${PROJECT_BINARY_DIR}/generated/debian/triggers" "activate-noawait ldconfig\n")
  set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA
    "${PROJECT_BINARY_DIR}/generated/debian/shlibs" "${PROJECT_BINARY_DIR}/generated/debian/triggers")
  string(APPEND CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS ", libtautline${abi} ${same_version}")
endif()
# the program's package has the guide to the cables
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_RECOMMENDS "tautline ${same_version}")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SUGGESTS "cmake, pkg-config, libbullet-dev, libode-dev")

include(CPack)
