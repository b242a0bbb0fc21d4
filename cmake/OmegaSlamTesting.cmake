# How tests become ctest entries: one function for each kind of test.
include(GoogleTest)
if(NOT DEFINED Python3_EXECUTABLE AND EXISTS /usr/bin/python3)
  set(Python3_EXECUTABLE /usr/bin/python3 CACHE FILEPATH "Python that ROS is installed for")
endif()
find_package(Python3 REQUIRED COMPONENTS Interpreter)

set(OMEGA_SLAM_TIMEOUT_FACTOR 1 CACHE STRING
  "By how much longer the cases of test programs may take, for many seeds or slow builds")

# A gtest binary; every case is a ctest entry of its own, and GTEST_SKIP shows up as skipped.
#   omega_slam_add_gtest(<target> LEVEL <label> PREFIX <name before each case> TIMEOUT <seconds>
#                        SOURCES <file>... [LIBRARIES <target>...])
function(omega_slam_add_gtest target)
  cmake_parse_arguments(TEST "" "LEVEL;PREFIX;TIMEOUT" "SOURCES;LIBRARIES" ${ARGN})
  add_executable(${target} ${TEST_SOURCES})
  # With catkin, programs go where rosrun finds them; a test is none of those.
  set_target_properties(${target} PROPERTIES
    RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/test_programs)
  target_link_libraries(${target} PRIVATE
    omega_slam_test_support ${TEST_LIBRARIES} GTest::gtest_main)
  math(EXPR timeout "${TEST_TIMEOUT} * ${OMEGA_SLAM_TIMEOUT_FACTOR}")
  gtest_discover_tests(${target} TEST_PREFIX ${TEST_PREFIX} DISCOVERY_TIMEOUT 60
    PROPERTIES LABELS ${TEST_LEVEL} TIMEOUT ${timeout}
      SKIP_REGULAR_EXPRESSION "\\[  SKIPPED \\]")
endfunction()

# One .test file run by the real rostest, on a master of its own.
#   omega_slam_add_rostest(<file>)
function(omega_slam_add_rostest file)
  get_filename_component(name ${file} NAME_WE)
  set(timeout 240)
  math(EXPR last_resort "${timeout} + 60")
  add_test(NAME rostest/${name}
    COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/cmake/run_rostest.py
      --environment ${CATKIN_DEVEL_PREFIX}/env.sh --source-dir ${PROJECT_SOURCE_DIR}
      --output-dir ${PROJECT_BINARY_DIR}/rostest/${name} --timeout ${timeout} ${file})
  # Two processors each: a handful of nodes that wait for one another must not starve.
  set_tests_properties(rostest/${name} PROPERTIES
    LABELS rostest TIMEOUT ${last_resort} PROCESSORS 2)
endfunction()

# A check of the package itself, a Python script: once for real, once on trees with known faults.
#   omega_slam_add_package_check(<file>)
function(omega_slam_add_package_check file)
  get_filename_component(name ${file} NAME_WE)
  set(command ${Python3_EXECUTABLE} ${file} --source-dir ${PROJECT_SOURCE_DIR}
    --build-dir ${PROJECT_BINARY_DIR})
  add_test(NAME package/${name} COMMAND ${command})
  add_test(NAME package/${name}/self_test COMMAND ${command} --self-test)
  set_tests_properties(package/${name} package/${name}/self_test PROPERTIES
    LABELS package TIMEOUT 900 SKIP_RETURN_CODE 77)
  # Compilers run in some of them; rostests beside those would starve.
  set_tests_properties(package/${name} PROPERTIES PROCESSORS 2)
endfunction()
