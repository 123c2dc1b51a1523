# SPDX-License-Identifier: MIT
# Precompiled headers. Half of the time that a file takes to compile goes into reading the standard library,
# fmt, glm and GoogleTest; compiled once, they serve every file. They hold headers of others only, never ours,
# and every file still includes what it uses: the naming check of .ci/run reads the sources without them, and
# so does a build with -DDERMIS_PRECOMPILE=OFF.
#
# dermis_precompiled(TARGET library|program|test)
#   Gives TARGET the headers for its kind. Two kinds of code differ in options (-fPIC, -fPIE, the level of
#   optimisation), and a compiler takes a precompiled header only with the options it was made with. Does
#   nothing where DERMIS_PRECOMPILE is OFF.

set(DERMIS_COMMON_HEADERS <algorithm> <array> <cmath> <cstddef> <cstdint> <cstdio> <cstdlib> <cstring>
  <filesystem> <fstream> <functional>
  <limits> <map> <memory> <numbers> <optional> <span> <string> <string_view> <utility> <vector> <fmt/format.h>
  <glm/glm.hpp>)

# One object library per kind, made when it is first asked for. It has a source of its own because CMake asks
# for one.
function(dermis_make_precompiled kind)
  find_package(glm REQUIRED)
  set(target dermis_headers_${kind})
  set(source ${PROJECT_BINARY_DIR}/precompiled/${kind}.cpp)
  file(CONFIGURE OUTPUT ${source} CONTENT "namespace { [[maybe_unused]] constexpr int nothing = 0; }\n")
  add_library(${target} OBJECT ${source})
  target_link_libraries(${target} PRIVATE fmt::fmt glm::glm)
  dermis_compile_options(${target})

  set(headers ${DERMIS_COMMON_HEADERS})
  if(NOT kind STREQUAL "library")
    dermis_program_options(${target})
  endif()
  if(kind STREQUAL "program")
    find_package(CLI11 REQUIRED)
    target_link_libraries(${target} PRIVATE CLI11::CLI11)
    list(APPEND headers <CLI/CLI.hpp>)
  endif()
  if(kind STREQUAL "test")
    target_link_libraries(${target} PRIVATE GTest::gtest)
    list(APPEND headers <gtest/gtest.h>)
  endif()
  target_precompile_headers(${target} PRIVATE ${headers})
endfunction()

function(dermis_precompiled target kind)
  if(NOT DERMIS_PRECOMPILE)
    return()
  endif()
  if(NOT TARGET dermis_headers_${kind})
    dermis_make_precompiled(${kind})
  endif()
  target_precompile_headers(${target} REUSE_FROM dermis_headers_${kind})
endfunction()
