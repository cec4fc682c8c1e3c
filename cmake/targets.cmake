include(GNUInstallDirs)
include(GoogleTest OPTIONAL)

# cbvh_library(NAME DIRECTORY... [LINK LIBRARY...] [LINK_PRIVATE LIBRARY...])
# makes the static library cbvh_NAME (alias cbvh::NAME) of all sources below the directories, main.cpp left out; a library
# without sources is headers only. LINK is what its headers need, LINK_PRIVATE what only its sources need.
# The repository's root is the include path: #include "golden/scene/mesh.h".
function(cbvh_library name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "LINK;LINK_PRIVATE")
  set(sources)
  foreach(directory IN LISTS arg_UNPARSED_ARGUMENTS)
    file(GLOB_RECURSE found CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${directory}/*.cpp)
    list(APPEND sources ${found})
  endforeach()
  list(FILTER sources EXCLUDE REGEX "/main\\.cpp$")
  if(sources)
    add_library(cbvh_${name} STATIC ${sources})
    set(visibility PUBLIC)
    target_link_libraries(cbvh_${name} PRIVATE ${arg_LINK_PRIVATE})
  else()
    add_library(cbvh_${name} INTERFACE)
    set(visibility INTERFACE)
  endif()
  add_library(cbvh::${name} ALIAS cbvh_${name})
  set_target_properties(cbvh_${name} PROPERTIES EXPORT_NAME ${name})
  target_include_directories(cbvh_${name} ${visibility}
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/cbvh>)
  target_link_libraries(cbvh_${name} ${visibility} cbvh_options ${arg_LINK})
endfunction()

# cbvh_tests(LABEL DIRECTORY LIBRARY...) makes one test executable of each *_test.cpp in the directory and gives its tests the label.
# The file's name adds to it: *_threads_test.cpp gets LABEL_threads and also runs under the thread sanitizer, *_nightly_test.cpp gets
# LABEL_nightly and is left out of scripts/test. (ctest -L takes a regular expression: -L unit finds all three.)
function(cbvh_tests label directory)
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${directory}/*_test.cpp)
  foreach(source IN LISTS sources)
    get_filename_component(name ${source} NAME_WE)
    set(source_label ${label})
    foreach(extra IN ITEMS threads nightly)
      if(name MATCHES "_${extra}_")
        set(source_label ${source_label}_${extra})
      endif()
    endforeach()
    add_executable(${name} ${source})
    target_link_libraries(${name} PRIVATE ${ARGN} GTest::gtest_main rapidcheck cbvh_options)
    gtest_discover_tests(${name} WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
      PROPERTIES LABELS ${source_label} DISCOVERY_TIMEOUT 60)
  endforeach()
endfunction()
