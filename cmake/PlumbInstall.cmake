# `cmake --install`: find_package(plumb), its components, and the program. docs/embedding.md
#
#   plumb_install(COMPONENT LIBRARIES… [HEADERS folders or headers…])
#
# The libraries become targets plumb::NAME of that component. What each component needs stands in plumbConfig.cmake.in.

set(PLUMB_PACKAGE "${CMAKE_INSTALL_LIBDIR}/cmake/plumb")
function(plumb_install component)
  cmake_parse_arguments(arg "" "" "HEADERS" ${ARGN})
  list(TRANSFORM arg_UNPARSED_ARGUMENTS PREPEND plumb_)
  install(TARGETS ${arg_UNPARSED_ARGUMENTS} EXPORT plumb_${component} ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
  install(EXPORT plumb_${component} NAMESPACE plumb:: DESTINATION ${PLUMB_PACKAGE})
  foreach(header IN LISTS arg_HEADERS)
    cmake_path(GET header PARENT_PATH folder)
    if(IS_DIRECTORY "${PROJECT_SOURCE_DIR}/${header}")
      install(DIRECTORY "${PROJECT_SOURCE_DIR}/${header}" DESTINATION ${PLUMB_INCLUDE}/${folder}
              FILES_MATCHING PATTERN "*.h" PATTERN suites EXCLUDE)
    else()
      install(FILES "${PROJECT_SOURCE_DIR}/${header}" DESTINATION ${PLUMB_INCLUDE}/${folder})
    endif()
  endforeach()
endfunction()

plumb_install(core core HEADERS core)
plumb_install(verification verification HEADERS verification)
plumb_install(checks checks HEADERS checks scenes/bsdfs/bsdf_model.h)
plumb_install(analytic analytic HEADERS analytic)
plumb_install(sampling densities debiasing points replicates mis HEADERS estimators)
plumb_install(estimators voronoi reweighting estimators)
plumb_install(main reports program main HEADERS cli/program.h)
install(TARGETS plumb)
install(TARGETS plumb_image_module LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/plumb)
# Made by the program itself, so that no verb is forgotten.
install(CODE [[
  set(share "$ENV{DESTDIR}${CMAKE_INSTALL_PREFIX}/share")
  file(MAKE_DIRECTORY "${share}/man/man1" "${share}/bash-completion/completions")
  execute_process(COMMAND "$<TARGET_FILE:plumb>" manual OUTPUT_FILE "${share}/man/man1/plumb.1" COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND "$<TARGET_FILE:plumb>" manual --completion
                  OUTPUT_FILE "${share}/bash-completion/completions/plumb" COMMAND_ERROR_IS_FATAL ANY)
]])
file(GLOB scenes CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/scenes/shipped/*/scene.xml")
foreach(scene IN LISTS scenes)
  cmake_path(GET scene PARENT_PATH folder)
  install(DIRECTORY "${folder}" DESTINATION ${CMAKE_INSTALL_DATADIR}/plumb/scenes
          PATTERN CMakeLists.txt EXCLUDE PATTERN "*.cpp" EXCLUDE)
endforeach()
include(CMakePackageConfigHelpers)
configure_package_config_file(cmake/plumbConfig.cmake.in plumbConfig.cmake INSTALL_DESTINATION ${PLUMB_PACKAGE})
write_basic_package_version_file(plumbConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/plumbConfig.cmake" "${CMAKE_CURRENT_BINARY_DIR}/plumbConfigVersion.cmake"
        DESTINATION ${PLUMB_PACKAGE})
