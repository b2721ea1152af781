# Installs the library, the headers, the program and what find_package(sailmap) needs.
include(CMakePackageConfigHelpers)
install(TARGETS sailmap_hls sailmap_csim sailmap_ref sailmap EXPORT sailmap-targets)
set_target_properties(sailmap_program PROPERTIES INSTALL_RPATH "$ORIGIN/../${CMAKE_INSTALL_LIBDIR}")
install(TARGETS sailmap_program)
install(FILES ${PROJECT_BINARY_DIR}/host/app/completions/sailmap
        DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
install(DIRECTORY ${PROJECT_BINARY_DIR}/host/app/man1/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
foreach(part hls hls/csim ref host)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${part}/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
endforeach()
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/sailmap)
install(EXPORT sailmap-targets NAMESPACE sailmap:: DESTINATION ${package_dir})
configure_package_config_file(cmake/sailmap-config.cmake.in sailmap-config.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(sailmap-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/sailmap-config.cmake ${PROJECT_BINARY_DIR}/sailmap-config-version.cmake
        DESTINATION ${package_dir})
install(FILES ${PROJECT_SOURCE_DIR}/share/paper_table.json DESTINATION ${CMAKE_INSTALL_DATADIR}/sailmap)
