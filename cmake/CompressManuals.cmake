# Called by cpack on what a package will hold: Debian wants manual pages compressed, and `man` reads them so
# wherever they are.
file(GLOB_RECURSE pages "${CPACK_TEMPORARY_INSTALL_DIRECTORY}/*.[13]")
list(FILTER pages INCLUDE REGEX "/share/man/man[13]/[^/]*$")
foreach(page IN LISTS pages)
  execute_process(COMMAND gzip -9nf "${page}" COMMAND_ERROR_IS_FATAL ANY)
endforeach()
