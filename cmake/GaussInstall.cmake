# `cmake --install`: the generator and the runtime headers, for find_package(gauss) in projects that do not build them.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/gauss)

install(TARGETS gauss-gen EXPORT gauss-targets)
install(TARGETS gauss_runtime EXPORT gauss-targets INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY src/gauss DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.hpp")
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
# What the documents lead to lies beside them, as in the source.
install(FILES README.md CHANGELOG.md CONTRIBUTING.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY docs models generated scenes DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES examples/turntable.cpp examples/long_swing.cpp examples/ensemble.cpp examples/ball_on_shaker.cpp examples/ball_on_shaker.yaml DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples)
install(DIRECTORY LICENSES DESTINATION ${CMAKE_INSTALL_DOCDIR})

install(EXPORT gauss-targets NAMESPACE gauss:: DESTINATION ${package_folder})
configure_package_config_file(cmake/gauss-config.cmake.in gauss-config.cmake INSTALL_DESTINATION ${package_folder})
# Before 1.0, what works with 0.1 need not work with 0.2.
write_basic_package_version_file(gauss-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/gauss-config.cmake ${PROJECT_BINARY_DIR}/gauss-config-version.cmake
              cmake/GaussAddModel.cmake
        DESTINATION ${package_folder})
