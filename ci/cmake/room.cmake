# Functions by which every room states its library and its tests.
include_guard(GLOBAL)

function(porowave_compile_options target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion
                                           $<$<BOOL:${POROWAVE_WARNINGS_AS_ERRORS}>:-Werror>)
  # GCC 12 sees an overlap in every "text" + std::string that it inlines (GCC bug 105651).
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
  if(POROWAVE_SANITIZE)
    target_compile_options(${target} PRIVATE -fsanitize=address,undefined
                                             -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_link_options(${target} PRIVATE -fsanitize=address,undefined)
  endif()
  if(POROWAVE_SANITIZE_THREADS)
    target_compile_options(${target} PRIVATE -fsanitize=thread -fno-omit-frame-pointer)
    target_link_options(${target} PRIVATE -fsanitize=thread)
  endif()
  if(POROWAVE_FUZZ)
    target_compile_options(${target} PRIVATE -fsanitize=fuzzer-no-link)
  endif()
endfunction()

# For what does no work worth optimising.
function(porowave_quick_to_compile target)
  target_compile_options(${target} PRIVATE
                         $<$<AND:$<CONFIG:Release>,$<CXX_COMPILER_ID:GNU>>:-O1>)
endfunction()

# Most of a clean build is templates that every source instantiates again. Sources compiled as one
# must not share names: tests keep theirs inside their suite.
function(porowave_unity target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${POROWAVE_UNITY_BUILD}
                                             UNITY_BUILD_BATCH_SIZE 8)
endfunction()

# porowave_library(name SOURCES ... PUBLIC ... PRIVATE ...): the library porowave::name, its sources
# given relative to the room. Headers are found by their path from the top of the tree.
function(porowave_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
  set(target porowave_${name})
  add_library(${target} STATIC ${ARG_SOURCES})
  add_library(porowave::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON)
  target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
                             $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/porowave>)
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_link_libraries(${target} PUBLIC ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE})
  porowave_compile_options(${target})
  porowave_unity(${target})
  set_property(GLOBAL APPEND PROPERTY POROWAVE_LIBRARIES ${target})
endfunction()

# porowave_tests(room LABEL label [PROGRAM name] [OPTIMISED] STEMS a b/c ... EXTRA ... LINK ...): one Boost.Test
# program of the room's test_main.cpp and a_test.cpp, b/c_test.cpp, ...; CTest runs each file's suite (named as its stem)
# by itself. OPTIMISED programs have work of their own to do. A suite that does not exist is an error of Boost.Test, so no file can be skipped.
function(porowave_tests room)
  if(NOT POROWAVE_TESTS)
    return()
  endif()
  cmake_parse_arguments(ARG "OPTIMISED" "LABEL;PROGRAM" "STEMS;EXTRA;LINK" ${ARGN})
  set(program ${room}_tests)
  if(ARG_PROGRAM)
    set(program ${ARG_PROGRAM}_tests)
  endif()
  set(sources test_main.cpp ${ARG_EXTRA})
  foreach(stem ${ARG_STEMS})
    list(APPEND sources ${stem}_test.cpp)
  endforeach()
  add_executable(${program} ${sources})
  # Half of a clean build is tests: what they time and call often is in the libraries.
  if(NOT ARG_OPTIMISED)
    porowave_quick_to_compile(${program})
  endif()
  # It says which module it is before it includes the same.
  set_source_files_properties(test_main.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  target_compile_definitions(${program} PRIVATE BOOST_TEST_DYN_LINK
                             POROWAVE_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  target_link_libraries(${program} PRIVATE ${ARG_LINK} Boost::unit_test_framework)
  porowave_compile_options(${program})
  porowave_unity(${program})
  foreach(stem ${ARG_STEMS})
    get_filename_component(suite ${stem} NAME)
    add_test(NAME ${room}/${stem} COMMAND ${program} --run_test=${suite}
             --log_level=message --report_level=short)
    set_tests_properties(${room}/${stem} PROPERTIES LABELS "${ARG_LABEL}" TIMEOUT 300
                         ENVIRONMENT "RC_PARAMS=seed=2026")  # the same properties in every run
  endforeach()
endfunction()
