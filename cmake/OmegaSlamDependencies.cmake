# Third-party libraries of the ROS-free library, gathered behind one target.
find_package(Eigen3 REQUIRED)
# PCL asks for VTK, and with it half a desktop, only to draw; we do not draw with it.
set(CMAKE_DISABLE_FIND_PACKAGE_VTK ON)
find_package(PCL REQUIRED COMPONENTS common kdtree search registration)
find_package(OpenCV REQUIRED COMPONENTS core imgproc imgcodecs features2d calib3d)
find_package(yaml-cpp REQUIRED)
find_package(fmt REQUIRED)
find_package(nanoflann REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
find_package(PNG REQUIRED)
find_package(Threads REQUIRED)

# SuiteSparse ships no CMake package on the systems we support.
find_path(CHOLMOD_INCLUDE_DIR cholmod.h PATH_SUFFIXES suitesparse)
find_library(CHOLMOD_LIBRARY cholmod)
if(NOT CHOLMOD_INCLUDE_DIR OR NOT CHOLMOD_LIBRARY)
  message(FATAL_ERROR "CHOLMOD (SuiteSparse) was not found: install libsuitesparse-dev.")
endif()

# Of OMPL only its core, not the simulators that its CMake package names as well.
find_package(ompl REQUIRED)
find_library(OMPL_LIBRARY ompl HINTS ${OMPL_LIBRARY_DIRS})
find_path(URDFDOM_INCLUDE_DIR urdf_parser/urdf_parser.h)
find_library(URDFDOM_LIBRARY urdfdom_model)
if(NOT OMPL_LIBRARY OR NOT URDFDOM_INCLUDE_DIR OR NOT URDFDOM_LIBRARY)
  message(FATAL_ERROR "OMPL or urdfdom was not found: install libompl-dev and liburdfdom-dev.")
endif()

# System headers: their warnings are not ours.
add_library(omega_slam_dependencies INTERFACE)
target_include_directories(omega_slam_dependencies SYSTEM INTERFACE
  ${PCL_INCLUDE_DIRS} ${OpenCV_INCLUDE_DIRS} ${CHOLMOD_INCLUDE_DIR}
  ${OMPL_INCLUDE_DIRS} ${URDFDOM_INCLUDE_DIR})
target_link_libraries(omega_slam_dependencies INTERFACE
  Eigen3::Eigen pcl_registration pcl_search pcl_kdtree pcl_common ${OpenCV_LIBS} yaml-cpp fmt::fmt
  nanoflann::nanoflann nlohmann_json::nlohmann_json CLI11::CLI11 PNG::PNG ${CHOLMOD_LIBRARY}
  ${OMPL_LIBRARY} ${URDFDOM_LIBRARY} Threads::Threads)
