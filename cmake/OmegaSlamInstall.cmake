# What `cmake --install` puts where: the same with and without ROS, only under other folders.

# Programs, and scripts that are programs.
file(GLOB OMEGA_SLAM_SCRIPTS CONFIGURE_DEPENDS scripts/*.py)
install(TARGETS ${OMEGA_SLAM_PROGRAMS} RUNTIME DESTINATION ${OMEGA_SLAM_BIN_DESTINATION})
install(PROGRAMS ${OMEGA_SLAM_SCRIPTS} DESTINATION ${OMEGA_SLAM_BIN_DESTINATION})

# The library for other packages: find_package(omega_slam), then link omega_slam::omega_slam.
set(cmake_destination ${OMEGA_SLAM_SHARE_DESTINATION}/cmake)
install(TARGETS omega_slam omega_slam_options omega_slam_dependencies EXPORT omega_slam-targets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT omega_slam-targets NAMESPACE omega_slam:: DESTINATION ${cmake_destination})
install(DIRECTORY src/omega_slam DESTINATION include FILES_MATCHING PATTERN "*.h")
if(WITH_ROS)
  # catkin writes the package's CMake configuration and includes omega_slam-extras.cmake from it,
  # in the devel space too.
  export(EXPORT omega_slam-targets NAMESPACE omega_slam::
    FILE ${CATKIN_DEVEL_PREFIX}/share/omega_slam/cmake/omega_slam-targets.cmake)
else()
  include(CMakePackageConfigHelpers)
  write_basic_package_version_file(${PROJECT_BINARY_DIR}/omega_slamConfigVersion.cmake
    COMPATIBILITY SameMinorVersion)
  install(FILES cmake/omega_slam-extras.cmake RENAME omega_slamConfig.cmake
    DESTINATION ${cmake_destination})
  install(FILES ${PROJECT_BINARY_DIR}/omega_slamConfigVersion.cmake
    DESTINATION ${cmake_destination})
endif()

# What launch files and programs read.
foreach(folder config launch maps urdf)
  if(IS_DIRECTORY ${PROJECT_SOURCE_DIR}/${folder})
    install(DIRECTORY ${folder} DESTINATION ${OMEGA_SLAM_SHARE_DESTINATION})
  endif()
endforeach()
install(FILES LICENSE DESTINATION ${OMEGA_SLAM_SHARE_DESTINATION})
