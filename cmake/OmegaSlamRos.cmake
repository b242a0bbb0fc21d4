# The ROS side: messages, the nodes' shared library, one executable a node.

# ROS is installed for the system's Python; a pyenv or conda that comes first in the PATH breaks catkin.
foreach(variable PYTHON_EXECUTABLE Python3_EXECUTABLE)
  if(NOT DEFINED ${variable} AND EXISTS /usr/bin/python3)
    set(${variable} /usr/bin/python3 CACHE FILEPATH "Python that ROS is installed for")
  endif()
endforeach()

find_package(catkin REQUIRED COMPONENTS
  actionlib diagnostic_msgs geometry_msgs map_msgs message_generation move_base_msgs nav_msgs rosbag roscpp
  rosgraph_msgs sensor_msgs std_msgs std_srvs tf2 tf2_msgs tf2_ros visualization_msgs)

file(GLOB OMEGA_SLAM_MSGS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR}/msg CONFIGURE_DEPENDS msg/*.msg)
file(GLOB OMEGA_SLAM_SRVS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR}/srv CONFIGURE_DEPENDS srv/*.srv)
add_message_files(FILES ${OMEGA_SLAM_MSGS})
if(OMEGA_SLAM_SRVS)
  add_service_files(FILES ${OMEGA_SLAM_SRVS})
endif()
generate_messages(DEPENDENCIES std_msgs)

# Others get the messages by ${omega_slam_INCLUDE_DIRS}, the library by omega_slam::omega_slam.
catkin_package(CATKIN_DEPENDS message_runtime std_msgs CFG_EXTRAS omega_slam-extras.cmake)

set(OMEGA_SLAM_BIN_DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
set(OMEGA_SLAM_SHARE_DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CATKIN_DEVEL_PREFIX}/${CATKIN_PACKAGE_BIN_DESTINATION})

file(GLOB OMEGA_SLAM_ROS_SOURCES CONFIGURE_DEPENDS src/nodes/common/*.cpp)
add_library(omega_slam_ros STATIC ${OMEGA_SLAM_ROS_SOURCES})
add_dependencies(omega_slam_ros ${${PROJECT_NAME}_EXPORTED_TARGETS})
target_include_directories(omega_slam_ros PUBLIC $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/src>)
target_include_directories(omega_slam_ros SYSTEM PUBLIC ${catkin_INCLUDE_DIRS})
target_compile_definitions(omega_slam_ros PUBLIC OMEGA_SLAM_WITH_ROS)
target_link_libraries(omega_slam_ros PUBLIC omega_slam ${catkin_LIBRARIES})

# One file directly under src/nodes is one node and one executable.
file(GLOB OMEGA_SLAM_NODES CONFIGURE_DEPENDS src/nodes/*.cpp)
foreach(source ${OMEGA_SLAM_NODES})
  get_filename_component(node ${source} NAME_WE)
  add_executable(${node} ${source})
  target_link_libraries(${node} PRIVATE omega_slam_ros)
  list(APPEND OMEGA_SLAM_PROGRAMS ${node})
endforeach()
