# Language level, warnings and sanitizers shared by every target of the project.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)

set(CBVH_SANITIZE "" CACHE STRING "Sanitizers for every target, as -fsanitize= takes them (address,undefined or thread)")

option(CBVH_FEW_BITS "Build the units for even N only (vectors/unit.h): for builds with sanitizers" OFF)

add_library(cbvh_options INTERFACE)
# Digests must not depend on the compiler: no fused multiply-add behind our back (DESIGN section 6, note d).
target_compile_options(cbvh_options INTERFACE -ffp-contract=off
  $<BUILD_INTERFACE:-Wall;-Wextra;-Wpedantic;-Wshadow;-Wconversion;-Werror>
  # g++ 12 warns of overlapping copies inside std::string at -O3, where there are none (GCC bug 105651).
  $<BUILD_INTERFACE:$<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>>)
if(CBVH_FEW_BITS)
  target_compile_definitions(cbvh_options INTERFACE $<BUILD_INTERFACE:CBVH_FEW_BITS>)
endif()
if(CBVH_SANITIZE)
  target_compile_options(cbvh_options INTERFACE $<BUILD_INTERFACE:-fsanitize=${CBVH_SANITIZE};-fno-omit-frame-pointer;-fno-sanitize-recover=all>)
  target_link_options(cbvh_options INTERFACE $<BUILD_INTERFACE:-fsanitize=${CBVH_SANITIZE}>)
endif()
