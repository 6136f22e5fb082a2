# Packages: for Debian one of each component that something is installed with, and an archive of all
# that runs from any folder. tools/package makes them.

# The release of Debian that is compiled on: the libraries that are needed are its own.
file(STRINGS /etc/os-release release REGEX "^VERSION_ID=")
string(REGEX REPLACE "[^0-9]" "" release "${release}")

set(CPACK_GENERATOR DEB TGZ)
set(CPACK_PACKAGE_NAME brume)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_CONTACT "Brume maintainers <maintainers@brume.invalid>")
set(CPACK_PACKAGE_FILE_NAME brume-${PROJECT_VERSION}-debian${release}-${CMAKE_SYSTEM_PROCESSOR})
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1~deb${release})
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${CMAKE_LIBRARY_OUTPUT_DIRECTORY})

# SOURCE_DATE_EPOCH, where it is set.
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
set(changelog ${CMAKE_CURRENT_BINARY_DIR}/changelog.Debian)
configure_file(packaging/changelog.in ${changelog} @ONLY)
execute_process(COMMAND gzip -9nf ${changelog})

get_cmake_property(components_in_use COMPONENTS)
set(CPACK_COMPONENTS_ALL)

# Makes a package of a component: SUMMARY is its line in lists, TEXT what else to say of it. Other
# arguments, such as DEPENDS, are CPACK_DEBIAN_<component>_PACKAGE_<argument>.
function(brume_package component name)
  if(NOT component IN_LIST components_in_use)
    return()
  endif()
  install(FILES packaging/copyright ${changelog}.gz
    DESTINATION ${CMAKE_INSTALL_DATAROOTDIR}/doc/${name} COMPONENT ${component})
  string(TOUPPER ${component} upper)
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${name} PARENT_SCOPE)
  cmake_parse_arguments(arg "" "SUMMARY;TEXT" "" ${ARGN})
  string(REPEAT "." 55 line)
  string(REGEX REPLACE "(${line}[^ ]*) " "\\1\n" lines "${arg_TEXT}")
  set(CPACK_COMPONENT_${upper}_DESCRIPTION "${arg_SUMMARY}\n${lines}" PARENT_SCOPE)
  set(rest ${arg_UNPARSED_ARGUMENTS})
  while(rest)
    list(POP_FRONT rest key value)
    set(CPACK_DEBIAN_${upper}_PACKAGE_${key} "${value}" PARENT_SCOPE)
  endwhile()
  set(CPACK_COMPONENTS_ALL ${CPACK_COMPONENTS_ALL} ${component} PARENT_SCOPE)
endfunction()

set(same_version "(= ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})")
set(method "It renders light that fog, modelled as Gaussians, scatters any number of times, and \
measures how far a picture is from the exact result.")
# What reads the editor's icons, a package of its own from Debian 13 on; OpenGL in software.
brume_package(programs brume SECTION graphics
  SUMMARY "editor and renderer for fog, smoke and steam"
  TEXT "${method} This package has the editor, the command line and sample scenes."
  DEPENDS "qt6-svg-plugins | libqt6svg6 (<< 6.6)"
  RECOMMENDS "brume-doc, fonts-dejavu-core, libgl1-mesa-dri, qt6-translations-l10n"
  SUGGESTS "ffmpeg")
set(library libbrume${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
brume_package(library ${library} SECTION libs
  SUMMARY "renderer for fog, smoke and steam: library"
  TEXT "${method} This package has the library that programs link. Scenes of other programs are read \
by one of the package brume."
  RECOMMENDS "brume"
  CONTROL_EXTRA ${CMAKE_CURRENT_LIST_DIR}/triggers)
brume_package(development libbrume-dev SECTION libdevel
  SUMMARY "renderer for fog, smoke and steam: headers"
  TEXT "${method} This package has what programs are compiled with, and examples."
  DEPENDS "${library} ${same_version}, libglm-dev")
# A module is of one version of Python.
math(EXPR next_minor "${Python_VERSION_MINOR} + 1")
brume_package(python python3-brume SECTION python
  SUMMARY "renderer for fog, smoke and steam: Python module"
  TEXT "${method} This package has the Python module."
  DEPENDS "${library} ${same_version}, python3 (>= 3.${Python_VERSION_MINOR}), python3 (<< 3.${next_minor}), python3-numpy")
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA ${CMAKE_CURRENT_LIST_DIR}/python/postinst
  ${CMAKE_CURRENT_LIST_DIR}/python/prerm)
brume_package(documentation brume-doc SECTION doc ARCHITECTURE all
  SUMMARY "editor and renderer for fog, smoke and steam: manual"
  TEXT "${method} This package has the manual as HTML, which the editor's menu Help opens.")

include(CPack)

# What is installed, without tests and benchmarks.
add_custom_target(packaged DEPENDS brume brume-bench brume_library brume-scene-reader html_manual shared_files)
if(BRUME_BUILD_PYTHON)
  add_dependencies(packaged brume_python)
endif()
if(BRUME_BUILD_EDITOR)
  add_dependencies(packaged brume-editor brume-vtk-points)
endif()
