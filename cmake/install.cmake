# `cmake --install`: libraries, headers, the cbvh command, and what find_package(cbvh) reads.
# Targets: cbvh::golden, cbvh::rtl_model, cbvh::vectors, cbvh::fpga_host, cbvh::testbench.
include(CMakePackageConfigHelpers)
set(config_directory ${CMAKE_INSTALL_LIBDIR}/cmake/cbvh)

set_target_properties(cbvh_options PROPERTIES EXPORT_NAME options)
install(TARGETS cbvh_options cbvh_golden cbvh_rtl_model cbvh_vectors cbvh_fpga_host cbvh_testbench EXPORT cbvh-targets)
if(TARGET cbvh)
  install(TARGETS cbvh)
endif()
install(DIRECTORY golden rtl_model vectors testbench
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/cbvh FILES_MATCHING PATTERN "*.h" PATTERN "*.inc")
install(DIRECTORY fpga/host DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/cbvh/fpga FILES_MATCHING PATTERN "*.h")

install(EXPORT cbvh-targets NAMESPACE cbvh:: DESTINATION ${config_directory})
configure_package_config_file(cmake/cbvh-config.cmake.in ${PROJECT_BINARY_DIR}/cbvh-config.cmake
  INSTALL_DESTINATION ${config_directory})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/cbvh-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/cbvh-config.cmake ${PROJECT_BINARY_DIR}/cbvh-config-version.cmake
  DESTINATION ${config_directory})
