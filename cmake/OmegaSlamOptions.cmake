# Compiler settings shared by every target of the package, and by nothing outside of it.
add_library(omega_slam_options INTERFACE)
target_compile_features(omega_slam_options INTERFACE cxx_std_17)
target_compile_options(omega_slam_options INTERFACE
  $<BUILD_INTERFACE:-Wall;-Wextra;-Wpedantic;-Wconversion;-Wshadow>
  # One rounding on every machine: no fused multiply-add behind our back.
  $<BUILD_INTERFACE:-ffp-contract=off>)
if(WERROR)
  target_compile_options(omega_slam_options INTERFACE $<BUILD_INTERFACE:-Werror>)
endif()
if(SANITIZE)
  string(REPLACE ";" "," sanitizers "${SANITIZE}")
  target_compile_options(omega_slam_options INTERFACE
    # GCC's documentation warns that sanitizers make this warning cry wolf; std::regex suffices.
    $<BUILD_INTERFACE:$<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>>
    $<BUILD_INTERFACE:-fsanitize=${sanitizers};-fno-omit-frame-pointer;-fno-sanitize-recover=all>)
  target_link_options(omega_slam_options INTERFACE $<BUILD_INTERFACE:-fsanitize=${sanitizers}>)
  # Under AddressSanitizer, Eigen aligns memory by hand, and would free what PCL's library, built
  # without, has allocated.
  target_compile_definitions(omega_slam_options INTERFACE
    $<BUILD_INTERFACE:EIGEN_MALLOC_ALREADY_ALIGNED=1>)
endif()
