include(GNUInstallDirs)

# cbvh_library(NAME DIRECTORY...) makes the static library cbvh_NAME (alias cbvh::NAME) from all sources below the directories.
# The repository's root is the include path: #include "golden/scene/mesh.h".
function(cbvh_library name)
  set(sources)
  foreach(directory IN LISTS ARGN)
    file(GLOB_RECURSE found CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${directory}/*.cpp)
    list(APPEND sources ${found})
  endforeach()
  if(sources)
    add_library(cbvh_${name} STATIC ${sources})
    set(visibility PUBLIC)
  else()
    add_library(cbvh_${name} INTERFACE)
    set(visibility INTERFACE)
  endif()
  add_library(cbvh::${name} ALIAS cbvh_${name})
  set_target_properties(cbvh_${name} PROPERTIES EXPORT_NAME ${name})
  target_include_directories(cbvh_${name} ${visibility}
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/cbvh>)
  target_link_libraries(cbvh_${name} ${visibility} cbvh_options)
endfunction()

# cbvh_tests(LABEL DIRECTORY LIBRARY...) makes one test executable of each *_test.cpp in the directory.
function(cbvh_tests label directory)
  include(GoogleTest)
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${directory}/*_test.cpp)
  foreach(source IN LISTS sources)
    get_filename_component(name ${source} NAME_WE)
    add_executable(${name} ${source})
    target_link_libraries(${name} PRIVATE ${ARGN} GTest::gtest_main rapidcheck cbvh_options)
    gtest_discover_tests(${name} WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
      PROPERTIES LABELS ${label} DISCOVERY_TIMEOUT 60)
  endforeach()
endfunction()
