# Where files are installed. The build folder is laid out in the same way, so that programs find
# their files by the same paths in both (core/io/installed_files).

# As in Debian's packages, whatever the prefix: what is built once serves both.
if(CMAKE_LIBRARY_ARCHITECTURE AND NOT DEFINED CMAKE_INSTALL_LIBDIR)
  set(CMAKE_INSTALL_LIBDIR lib/${CMAKE_LIBRARY_ARCHITECTURE} CACHE PATH "Folder of libraries")
endif()
include(GNUInstallDirs)

# Of programs that others start, of scenes and pictures, of the manual.
set(BRUME_INSTALL_HELPERS ${CMAKE_INSTALL_LIBEXECDIR}/brume)
set(BRUME_INSTALL_RESOURCES ${CMAKE_INSTALL_DATADIR}/brume)
set(BRUME_INSTALL_MANUAL ${CMAKE_INSTALL_DATAROOTDIR}/doc/brume/html)

set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_BINDIR})
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR})

# Programs that others start: built into and installed in a folder of their own.
function(brume_helpers)
  set_target_properties(${ARGN} PROPERTIES
    RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/${BRUME_INSTALL_HELPERS})
  install(TARGETS ${ARGN} RUNTIME DESTINATION ${BRUME_INSTALL_HELPERS} COMPONENT programs)
endfunction()
