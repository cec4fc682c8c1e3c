# Compiles through ccache where it is installed. Clones in different folders share its entries.
option(CBVH_CCACHE "Compile through ccache when it is installed" ON)
find_program(CBVH_CCACHE_PROGRAM ccache)
mark_as_advanced(CBVH_CCACHE_PROGRAM)
if(CBVH_CCACHE AND CBVH_CCACHE_PROGRAM AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER
    ${CMAKE_COMMAND} -E env CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_NOHASHDIR=1 ${CBVH_CCACHE_PROGRAM})
endif()
# Source paths in the objects are relative to the repository's root, so that two clones build the same bytes.
add_compile_options($<$<NOT:$<CONFIG:Debug>>:-ffile-prefix-map=${PROJECT_SOURCE_DIR}=.>)
