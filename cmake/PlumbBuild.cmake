# How every folder of Plumb is built.
#
#   plumb_library(NAME [SOURCES…] [DEPENDS targets…])   a folder's target plumb::NAME; without sources, of headers alone
#     … [PRECOMPILED TARGET <HEADER>]                   whose sources include this slow header of a library
#   plumb_test(NAME SOURCES… [DEPENDS targets…])      its unit tests, one executable, each test known to ctest
#   plumb_claims(NAME FILES…)                         files of claims: folder/file.cpp defines add_folder_file(Catalogue&)
#   plumb_heavy_sources(TARGET SOURCES… [DEPENDS targets…])   units of TARGET that need about 1 GB each to compile
#
# Compile time is a budget (2 cores): one precompiled header for the libraries, one for the tests, and a ninja pool
# of depth 1 for the units that need about 1 GB each (CGAL).

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_CXX_FLAGS_DEBUG "-Og -g1")
set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG")
# For its warnings: the linker sees all units at once, and with them two types or declarations of one name.
set(CMAKE_CXX_FLAGS_LTO "-O1 -DNDEBUG -flto=auto -Werror=odr -Werror=lto-type-mismatch")
set_property(GLOBAL PROPERTY JOB_POOLS heavy=1)

include(GNUInstallDirs)
set(PLUMB_INCLUDE "${CMAKE_INSTALL_INCLUDEDIR}/plumb")   # installed headers keep their paths below it

set(PLUMB_SANITIZE "" CACHE STRING "Sanitizers to build with, e.g. address,undefined")
set(PLUMB_EXECUTOR "tbb" CACHE STRING "What runs for_batches: tbb or jthread")
option(PLUMB_WERROR "Warnings are errors" OFF)

find_program(PLUMB_CCACHE ccache)
if(PLUMB_CCACHE)
  # The sloppiness is what ccache's manual asks for with precompiled headers; a changed header still misses. Without
  # debug information no object knows where its sources lie: copies of the tree share what they have in common.
  set(PLUMB_CCACHE_SETTINGS CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime)
  if(CMAKE_BUILD_TYPE STREQUAL "Release")
    list(APPEND PLUMB_CCACHE_SETTINGS "CCACHE_BASEDIR=${PROJECT_SOURCE_DIR}" CCACHE_NOHASHDIR=true)
  endif()
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env ${PLUMB_CCACHE_SETTINGS} ${PLUMB_CCACHE})
endif()

# How our own code is compiled. Installed targets carry none of it (BUILD_INTERFACE below): warnings are our affair, and
# no flag here changes how a type is laid out or a function is called (docs/embedding.md, "Compilers and flags").
add_library(plumb_options INTERFACE)
target_include_directories(plumb_options INTERFACE "${PROJECT_SOURCE_DIR}")
# -ffp-contract=off and no -ffast-math: the same seed gives the same bits.
target_compile_options(plumb_options INTERFACE
  -march=x86-64-v3 -ffp-contract=off -fpch-preprocess -Wall -Wextra -Wconversion -Wno-sign-conversion
  $<$<BOOL:${PLUMB_WERROR}>:-Werror>)
# Vectors, spectra and hits are written number by number and soon copied whole. Copied in words of 8 bytes, what is on
# its way to memory is handed on; in 16 bytes, as GCC likes to, each copy waits for it: `path` is 1.2 times as fast so.
set(PLUMB_WORD_COPIES -fno-tree-vectorize "-mtune-ctrl=^sse_unaligned_load_optimal,^sse_unaligned_store_optimal")
include(CheckCXXCompilerFlag)
check_cxx_compiler_flag("${PLUMB_WORD_COPIES}" PLUMB_COPIES_IN_WORDS)
if(PLUMB_COPIES_IN_WORDS)
  target_compile_options(plumb_options INTERFACE ${PLUMB_WORD_COPIES})
endif()
find_program(PLUMB_LLD ld.lld)
if(PLUMB_LLD AND NOT CMAKE_BUILD_TYPE STREQUAL "Lto")   # which knows no GCC's intermediate code
  target_link_options(plumb_options INTERFACE -fuse-ld=lld)
endif()
if(PLUMB_SANITIZE)
  target_compile_options(plumb_options INTERFACE -fsanitize=${PLUMB_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(plumb_options INTERFACE -fsanitize=${PLUMB_SANITIZE})
endif()

# LIBRARY and HEADERS, where given: a library whose headers are slow to compile.
function(plumb_precompiled_headers target owner)
  cmake_parse_arguments(arg "" "LIBRARY" "HEADERS" ${ARGN})
  if(NOT TARGET ${owner})
    file(WRITE "${CMAKE_BINARY_DIR}/${owner}.cpp" "")
    add_library(${owner} OBJECT "${CMAKE_BINARY_DIR}/${owner}.cpp")
    target_link_libraries(${owner} PRIVATE plumb_options fmt::fmt ${arg_LIBRARY})
    target_precompile_headers(${owner} PRIVATE
      <algorithm> <array> <cmath> <cstdint> <functional> <limits> <map> <memory> <numeric> <optional> <random> <span>
      <stdexcept> <string> <string_view> <utility> <variant> <vector> <fmt/format.h> ${arg_HEADERS})
  endif()
  target_precompile_headers(${target} REUSE_FROM ${owner})
endfunction()

function(plumb_library name)
  cmake_parse_arguments(arg "" "" "DEPENDS;PRECOMPILED" ${ARGN})
  set(scope PUBLIC)
  if(arg_UNPARSED_ARGUMENTS)
    add_library(plumb_${name} STATIC ${arg_UNPARSED_ARGUMENTS})
    if(arg_PRECOMPILED)
      list(GET arg_PRECOMPILED 0 library)
      list(GET arg_PRECOMPILED 1 header)
      string(MAKE_C_IDENTIFIER "plumb_pch_${library}" owner)
      plumb_precompiled_headers(plumb_${name} ${owner} LIBRARY ${library} HEADERS ${header})
      target_link_libraries(plumb_${name} PRIVATE $<BUILD_INTERFACE:${library}>)
    else()
      plumb_precompiled_headers(plumb_${name} plumb_pch)
    endif()
  else()
    add_library(plumb_${name} INTERFACE)
    set(scope INTERFACE)
  endif()
  add_library(plumb::${name} ALIAS plumb_${name})
  target_link_libraries(plumb_${name} ${scope} $<BUILD_INTERFACE:plumb_options> fmt::fmt ${arg_DEPENDS})
  target_include_directories(plumb_${name} INTERFACE $<INSTALL_INTERFACE:${PLUMB_INCLUDE}>)
  target_compile_features(plumb_${name} ${scope} cxx_std_20)
  set_target_properties(plumb_${name} PROPERTIES EXPORT_NAME ${name})
endfunction()

function(plumb_test name)
  cmake_parse_arguments(arg "" "" "DEPENDS" ${ARGN})
  add_executable(${name} ${arg_UNPARSED_ARGUMENTS})
  target_link_libraries(${name} PRIVATE plumb_options GTest::gmock GTest::gtest_main ${arg_DEPENDS})
  plumb_precompiled_headers(${name} plumb_test_pch LIBRARY GTest::gmock HEADERS <gtest/gtest.h> <gmock/gmock.h>)
  include(GoogleTest)
  set(environment "")
  if(PLUMB_SANITIZE STREQUAL "thread")
    set(environment ENVIRONMENT "TSAN_OPTIONS=suppressions=${PROJECT_SOURCE_DIR}/cmake/tsan.supp ignore_noninstrumented_modules=1")
  elseif(PLUMB_SANITIZE MATCHES "address")
    # LeakSanitizer takes a wrong range for the thread-local memory of libraries that are loaded late (OpenImageIO), and
    # ends by a fault of its own.
    set(environment ENVIRONMENT "ASAN_OPTIONS=intercept_tls_get_addr=0")
  endif()
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST PROPERTIES TIMEOUT 300 ${environment})
endfunction()

# Compiles files of claims and writes catalogue.cpp: shipped_catalogue(), which calls each of them in the order given. A
# claim in a new file costs the file and its line here.
function(plumb_claims name)
  set(declarations "")
  set(calls "")
  foreach(file IN LISTS ARGN)
    target_sources(plumb_${name} PRIVATE "${file}.cpp")
    string(MAKE_C_IDENTIFIER "add_${file}" add)
    string(APPEND declarations "void ${add}(Catalogue& catalogue);\n")
    string(APPEND calls "    ${add}(catalogue);\n")
  endforeach()
  set(catalogue "${CMAKE_CURRENT_BINARY_DIR}/catalogue.cpp")
  file(CONFIGURE OUTPUT "${catalogue}" @ONLY CONTENT [[
#include "verification/suites/suites.h"

namespace plumb::suites {

@declarations@
Catalogue shipped_catalogue() {
    Catalogue catalogue;
@calls@    return catalogue;
}

}  // namespace plumb::suites
]])
  target_sources(plumb_${name} PRIVATE "${catalogue}")
endfunction()

# Units that need much memory (CGAL) become part of a target, compiled one at a time and without the precompiled header:
# the libraries in DEPENDS, which the rest of the target does not see, bring flags of their own.
function(plumb_heavy_sources target)
  cmake_parse_arguments(arg "" "" "DEPENDS" ${ARGN})
  add_library(${target}_heavy OBJECT ${arg_UNPARSED_ARGUMENTS})
  target_link_libraries(${target}_heavy PRIVATE plumb_options ${arg_DEPENDS})
  set_target_properties(${target}_heavy PROPERTIES JOB_POOL_COMPILE heavy)
  target_sources(${target} PRIVATE $<TARGET_OBJECTS:${target}_heavy>)
  target_link_libraries(${target} PRIVATE ${arg_DEPENDS})
endfunction()
