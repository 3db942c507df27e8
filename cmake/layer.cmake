# How a library of src/ and its tests are declared. Each library sees only the headers of the
# libraries it names under PUBLIC or PRIVATE, which is how the floors of src/README.md are held.

set(REGARMENT_WARNINGS -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
    -Wnon-virtual-dtor -Wold-style-cast -Wcast-align -Woverloaded-virtual -Wnull-dereference
    -Wdouble-promotion -Wformat=2 -Werror)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # GCC 12 reports dereferences inside Eigen's and the standard library's inlined code.
  list(APPEND REGARMENT_WARNINGS -Wno-null-dereference -Wno-maybe-uninitialized -Wno-array-bounds
       -Wno-stringop-overflow -Wno-restrict)
endif()

add_library(regarment_options INTERFACE)
# No floating-point contraction: the same bytes from every compiler setting we ship.
target_compile_options(regarment_options INTERFACE ${REGARMENT_WARNINGS} -ffp-contract=off)
if(REGARMENT_SANITIZE)
  target_compile_options(regarment_options INTERFACE -fsanitize=${REGARMENT_SANITIZE}
                         -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(regarment_options INTERFACE -fsanitize=${REGARMENT_SANITIZE})
endif()
if(REGARMENT_FUZZ)
  target_compile_options(regarment_options INTERFACE -fsanitize=fuzzer-no-link)
endif()

find_package(Eigen3 3.4 REQUIRED NO_MODULE)

# One code model for libraries and programs, or the programs could not use the compiled headers.
set(CMAKE_CXX_COMPILE_OPTIONS_PIE ${CMAKE_CXX_COMPILE_OPTIONS_PIC})

# The standard headers and Eigen, compiled once for all libraries and tests.
file(WRITE ${CMAKE_BINARY_DIR}/pch.cpp "")
add_library(regarment_pch OBJECT ${CMAKE_BINARY_DIR}/pch.cpp)
target_link_libraries(regarment_pch PRIVATE regarment_options Eigen3::Eigen)
target_precompile_headers(regarment_pch PRIVATE <algorithm> <array> <cmath> <filesystem> <fstream>
    <functional> <limits> <map> <memory> <optional> <sstream> <string> <vector> <Eigen/Core>
    <Eigen/Geometry>)
# -Winvalid-pch does not understand the clang build, and a compile without the header is still right.

# add_layer(NAME SOURCES a.cpp ... [PUBLIC libs] [PRIVATE libs] [SYSTEM third-party libs])
function(add_layer name)
  cmake_parse_arguments(ARG "" "" "SOURCES;PUBLIC;PRIVATE;SYSTEM" ${ARGN})
  add_library(${name} STATIC ${ARG_SOURCES})
  # Each library has an include folder of its own that holds nothing but itself.
  set(view ${CMAKE_BINARY_DIR}/include/${name})
  file(MAKE_DIRECTORY ${view})
  file(CREATE_LINK ${CMAKE_CURRENT_SOURCE_DIR} ${view}/${name} SYMBOLIC)
  target_include_directories(${name} PUBLIC $<BUILD_INTERFACE:${view}>
                             $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/regarment>)
  target_link_libraries(${name} PUBLIC ${ARG_PUBLIC} Eigen3::Eigen PRIVATE regarment_options ${ARG_PRIVATE} ${ARG_SYSTEM})
  target_precompile_headers(${name} REUSE_FROM regarment_pch)
endfunction()

# add_layer_test(NAME SOURCES a_test.cpp ... LIBS libs): one test program per library, label NAME.
function(add_layer_test name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LIBS" ${ARGN})
  add_executable(${name}_test ${ARG_SOURCES})
  target_link_libraries(${name}_test PRIVATE regarment_options ${ARG_LIBS} test_support GTest::gtest_main)
  target_precompile_headers(${name}_test REUSE_FROM regarment_pch)
  gtest_discover_tests(${name}_test PROPERTIES LABELS ${name} TIMEOUT 300 DISCOVERY_TIMEOUT 60)
endfunction()
