# The library as a CMake package: find_package(stepmill), link to stepmill::stepmill or one of its modules.
include(CMakePackageConfigHelpers)

list(TRANSFORM STEPMILL_MODULES PREPEND stepmill_ OUTPUT_VARIABLE stepmill_installed)
install(TARGETS ${stepmill_installed} stepmill stepmill_geos stepmill_occt EXPORT stepmill
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(TARGETS stepmill-app RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY include/stepmill DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})

set(stepmill_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/stepmill)
install(EXPORT stepmill NAMESPACE stepmill:: FILE stepmill-targets.cmake DESTINATION ${stepmill_package_dir})
install(FILES cmake/stepmill-config.cmake DESTINATION ${stepmill_package_dir})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/stepmill-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/stepmill-config-version.cmake DESTINATION ${stepmill_package_dir})
