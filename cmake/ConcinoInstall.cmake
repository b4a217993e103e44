# Install rules: the three roots merge into one include/concino, and find_package(concino COMPONENTS ...) finds every target.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(concino_config_dir ${CMAKE_INSTALL_DATADIR}/cmake/concino)
get_property(components GLOBAL PROPERTY concino_components)
get_property(adapters GLOBAL PROPERTY concino_adapters)

set(CONCINO_COMPONENT_LIST "${components}")
set(CONCINO_COMPONENT_TABLE "")
foreach(name IN LISTS components)
  get_property(target GLOBAL PROPERTY concino_target_${name})
  get_property(calls GLOBAL PROPERTY concino_find_${name})
  get_property(files GLOBAL PROPERTY concino_files_${name})
  set(file_set "")
  if(files)
    set(file_set FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT headers
      FILE_SET details DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT headers)
  endif()
  install(TARGETS ${target} EXPORT concino-${name} ${file_set})
  get_property(compiled GLOBAL PROPERTY concino_compiled_target_${name})
  if(compiled)
    install(TARGETS ${compiled} EXPORT concino-${name} ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
  endif()
  install(EXPORT concino-${name} NAMESPACE concino:: DESTINATION ${concino_config_dir} FILE concino-${name}.cmake)
  get_property(needs GLOBAL PROPERTY concino_needs_${name})
  string(APPEND CONCINO_COMPONENT_TABLE "set(_concino_find_${name} \"${calls}\")\nset(_concino_needs_${name} \"${needs}\")\n")
endforeach()
foreach(name IN LISTS adapters)
  get_property(packages GLOBAL PROPERTY concino_debian_${name})
  string(APPEND CONCINO_COMPONENT_TABLE "set(_concino_debian_${name} \"${packages}\")\n")
endforeach()

# The compiled library depends on the architecture, so it is a package of its own beside the others, which concinoConfig.cmake finds.
if(CONCINO_BUILD_COMPILED)
  set(concino_compiled_dir ${CMAKE_INSTALL_LIBDIR}/cmake/concino-compiled)
  install(TARGETS concino_compiled EXPORT concino-compiled ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
  install(EXPORT concino-compiled NAMESPACE concino:: DESTINATION ${concino_compiled_dir} FILE concino-compiled-config.cmake)
  write_basic_package_version_file(${PROJECT_BINARY_DIR}/concino-compiled-config-version.cmake COMPATIBILITY ExactVersion)
  install(FILES ${PROJECT_BINARY_DIR}/concino-compiled-config-version.cmake DESTINATION ${concino_compiled_dir})
endif()

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/concinoConfig.cmake.in ${PROJECT_BINARY_DIR}/concinoConfig.cmake
  INSTALL_DESTINATION ${concino_config_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/concinoConfigVersion.cmake COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
install(FILES ${PROJECT_BINARY_DIR}/concinoConfig.cmake ${PROJECT_BINARY_DIR}/concinoConfigVersion.cmake ${CMAKE_CURRENT_LIST_DIR}/ConcinoCheckLinks.cmake
  ${CMAKE_CURRENT_LIST_DIR}/ConcinoPrecompile.cmake DESTINATION ${concino_config_dir})
install(DIRECTORY ${CMAKE_CURRENT_LIST_DIR}/modules DESTINATION ${concino_config_dir})
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/LICENSE-font.txt DESTINATION ${CMAKE_INSTALL_DOCDIR})
