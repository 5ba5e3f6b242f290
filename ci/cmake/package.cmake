# Install rules, find_package(porowave) and the Debian package.
include(CMakePackageConfigHelpers)

get_property(libraries GLOBAL PROPERTY POROWAVE_LIBRARIES)
install(TARGETS ${libraries} porowave EXPORT porowaveTargets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
        RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
foreach(room reference solver verification reports)
  install(DIRECTORY ${room} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/porowave
          FILES_MATCHING PATTERN "*.hpp" PATTERN "tables" EXCLUDE PATTERN "gallery" EXCLUDE
          PATTERN "studies" EXCLUDE PATTERN "baselines" EXCLUDE
          PATTERN "*_fixtures.hpp" EXCLUDE PATTERN "test_*.hpp" EXCLUDE
          PATTERN "random_*.hpp" EXCLUDE)  # these serve the tests
endforeach()

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/porowave)
install(EXPORT porowaveTargets NAMESPACE porowave:: DESTINATION ${package_dir})
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/porowaveConfig.cmake.in
                              ${PROJECT_BINARY_DIR}/porowaveConfig.cmake
                              INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/porowaveConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/porowaveConfig.cmake
              ${PROJECT_BINARY_DIR}/porowaveConfigVersion.cmake DESTINATION ${package_dir})
install(FILES LICENSE README.md DESTINATION ${CMAKE_INSTALL_DOCDIR})

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "the porowave developers")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_PROJECT_CONFIG_FILE ${CMAKE_CURRENT_LIST_DIR}/deb_tools.cmake)
set(CPACK_STRIP_FILES ON)
# A program's user needs gnuplot; a library's user needs what porowaveConfig.cmake looks for.
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "gnuplot-nox")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS
    "libeigen3-dev, libtomlplusplus-dev, libfmt-dev, nlohmann-json3-dev, libgsl-dev, libfftw3-dev, pkg-config")
include(CPack)
