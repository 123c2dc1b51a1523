# SPDX-License-Identifier: MIT
# dermis_module(NAME SOURCES ... DEPENDS modules ... LINKS libraries ... [LIGHTLY])
#   One static library dermis_NAME for the folder src/NAME. DEPENDS names other rooms of the house (public);
#   LINKS names outside libraries (private). A folder of headers alone has no SOURCES. The pairs are written
#   to build/house.txt, against which the include check of tests/house holds every #include. LIGHTLY: compiled
#   with -O1, in two thirds of the time, for rooms that read, check and arrange and compute next to nothing.
# dermis_test(NAME SOURCES ... DEPENDS modules ... LINKS libraries ... [LABEL unit|gpu|house|docs]
#             [COST seconds] [LONG] [COMPUTES] [SHORT filter ...] [ENVIRONMENT variable=value ...]
#             [PARTS name filter seconds ...])
#   One GoogleTest executable test_NAME, registered as ONE ctest entry (its cases share a process, so fixtures
#   load once).
#   COMPUTES: compiled as the library is, for tests that themselves compute over thousands of texels.
#   COST: processor seconds, roughly; what takes longest starts first, so that nothing long is left alone at
#   the end.
#   ENVIRONMENT: variables of all entries of the test. With GALLIVM_PERF=nopt Mesa's software driver does not
#   optimise shaders: right for a test of many shaders and few pixels, which else waits for the compiler.
#   PARTS: cases of a long test that are an entry of their own, NAME_part, so that no processor waits for
#   another at the end; the filter is GoogleTest's, without a "-". A case belongs to the first part that names
#   it, and in no part to the entry NAME.
#   The short tier, `./run test`, is every test of the labels unit and house, less those that say LONG and
#   parts called "long", and of the other labels the cases of SHORT, which are a part of that name. The target
#   short_tests builds its programs and nothing else.
#   Tests of the labels unit and gpu share one folder for kept files (build/.../cache), emptied when the tests
#   begin (tests/CMakeLists.txt): what one has baked serves the others, and nothing of the user's own cache
#   decides what is tested.
# dermis_script_test(NAME SCRIPT file [LABEL unit|gpu|house|docs] [COST seconds] [LONG] [ARGS ...])
#   A bash script as one ctest entry, given the source folder and ARGS as its arguments; it ends with a status
#   other than 0 on failure.
# The target unit_tests builds what the label unit needs and nothing else: the sanitizer run needs no more.

include(DermisPrecompiled)

set_property(GLOBAL PROPERTY DERMIS_HOUSE "")
add_custom_target(unit_tests)
add_custom_target(short_tests)

# Deferred to the end of the configuration, when every room has said what it depends on.
function(dermis_write_house)
  get_property(house GLOBAL PROPERTY DERMIS_HOUSE)
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/house.txt CONTENT "${house}")
endfunction()
cmake_language(DEFER DIRECTORY ${PROJECT_SOURCE_DIR} CALL dermis_write_house)

function(dermis_compile_options target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wconversion -Wno-sign-conversion
    -Wno-missing-field-initializers)   # designated initialisers leave the rest at their defaults, on purpose
  if(DERMIS_UNITY AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # These two take names of the files beside for names of the same file, or of a header.
    target_compile_options(${target} PRIVATE -Wshadow=local -Wno-subobject-linkage)
  else()
    target_compile_options(${target} PRIVATE -Wshadow)
  endif()
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # Collects its garbage from a gigabyte on, which files compiled together seldom reach: a twelfth of its
    # time.
    target_compile_options(${target} PRIVATE --param=ggc-min-heapsize=1000000)
  endif()
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    # g++ 12 invents overlaps in "text" + std::string once it has inlined it:
    # https://gcc.gnu.org/bugzilla/show_bug.cgi?id=105651
    target_compile_options(${target} PRIVATE -Wno-restrict)
  endif()
  if(DERMIS_WARNINGS_AS_ERRORS)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  if(DERMIS_SANITIZE STREQUAL "address")
    target_compile_options(${target} PRIVATE -fsanitize=address,undefined -fno-sanitize-recover=all
      -fno-omit-frame-pointer)
    target_link_options(${target} PRIVATE -fsanitize=address,undefined)
  elseif(DERMIS_SANITIZE STREQUAL "thread")
    target_compile_options(${target} PRIVATE -fsanitize=thread -fno-omit-frame-pointer)
    target_link_options(${target} PRIVATE -fsanitize=thread)
  elseif(DERMIS_SANITIZE)
    message(FATAL_ERROR "DERMIS_SANITIZE is '${DERMIS_SANITIZE}', not OFF, address or thread")
  endif()
  if(DERMIS_FUZZ)
    # Warnings are g++'s to give. A float that does not fit an integer is no part of clang's "undefined", and
    # is what hostile numbers do.
    target_compile_options(${target}
      PRIVATE -w -fsanitize=fuzzer-no-link,address,undefined,float-cast-overflow -fno-sanitize-recover=all
      -fno-omit-frame-pointer)
    target_link_options(${target} PRIVATE -fsanitize=fuzzer-no-link,address,undefined)
  endif()
endfunction()

# Code around the library: tests, the command line. It is not optimised; what it calls is compiled as ever.
# -fPIE for programs and for libraries of their parts alike, so that all share one precompiled header.
function(dermis_program_options target)
  set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE OFF)
  target_compile_options(${target} PRIVATE -fPIE $<$<CONFIG:Release>:-O0>)
  if(DERMIS_SANITIZE)
    target_compile_options(${target} PRIVATE -O0)
  endif()
  if(DERMIS_SANITIZE STREQUAL "address")
    # These checks of each pointer take half the compiler's time; one that leads nowhere is met at its use.
    target_compile_options(${target} PRIVATE -fno-sanitize=null,alignment,vptr,object-size,pointer-overflow)
  endif()
endfunction()

function(dermis_module name)
  cmake_parse_arguments(M "LIGHTLY" "" "SOURCES;DEPENDS;LINKS" ${ARGN})
  if(M_SOURCES)
    set(public PUBLIC)
    add_library(dermis_${name} STATIC ${M_SOURCES})
    dermis_compile_options(dermis_${name})
    dermis_precompiled(dermis_${name} library)
    if(M_LIGHTLY)
      target_compile_options(dermis_${name} PRIVATE $<$<CONFIG:Release>:-O1>)
    endif()
    target_link_libraries(dermis_${name} PRIVATE ${M_LINKS})
  else()
    set(public INTERFACE)
    add_library(dermis_${name} INTERFACE)
    target_link_libraries(dermis_${name} INTERFACE ${M_LINKS})
  endif()
  target_include_directories(dermis_${name} ${public}
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>)
  foreach(dep IN LISTS M_DEPENDS)
    target_link_libraries(dermis_${name} ${public} dermis_${dep})
  endforeach()
  list(JOIN M_DEPENDS " " deps)
  set_property(GLOBAL APPEND_STRING PROPERTY DERMIS_HOUSE "${name}: ${deps}\n")
endfunction()

# Returns the labels of an entry: its own, and "short" where it belongs to the short tier.
function(dermis_labels result label long part)
  set(labels ${label})
  if(part STREQUAL "short" OR (label MATCHES "unit|house" AND NOT long AND NOT part STREQUAL "long"))
    list(APPEND labels short)
  endif()
  set(${result} ${labels} PARENT_SCOPE)
endfunction()

# Registers test_EXECUTABLE once more, or for the first time, with the cases of a filter; then variables.
function(dermis_test_entry entry executable labels cost filter)
  add_test(NAME ${entry} COMMAND test_${executable} ${filter} WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
  set(variables ${ARGN})
  if(labels MATCHES "unit|gpu")
    list(APPEND variables XDG_CACHE_HOME=${PROJECT_BINARY_DIR}/cache)
    set_tests_properties(${entry} PROPERTIES FIXTURES_REQUIRED empty_cache)
  endif()
  set_tests_properties(${entry} PROPERTIES LABELS "${labels}" TIMEOUT 1200 COST ${cost}
    ENVIRONMENT "${variables}")
  if("short" IN_LIST labels)
    add_dependencies(short_tests test_${executable})
  endif()
endfunction()

function(dermis_test name)
  cmake_parse_arguments(T "LONG;COMPUTES" "LABEL;COST" "SOURCES;DEPENDS;LINKS;ENVIRONMENT;PARTS;SHORT"
    ${ARGN})
  add_executable(test_${name} ${T_SOURCES})
  target_include_directories(test_${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  dermis_compile_options(test_${name})
  if(NOT T_COMPUTES)
    dermis_program_options(test_${name})
    dermis_precompiled(test_${name} test)
  endif()
  foreach(dep IN LISTS T_DEPENDS)
    target_link_libraries(test_${name} PRIVATE dermis_${dep})
  endforeach()
  target_link_libraries(test_${name} PRIVATE ${T_LINKS} GTest::gtest GTest::gtest_main)
  target_compile_definitions(test_${name} PRIVATE DERMIS_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  if(NOT T_LABEL)
    set(T_LABEL unit)
  endif()
  if(NOT T_COST)
    set(T_COST 5)
  endif()

  if(T_LABEL STREQUAL "unit")
    add_dependencies(unit_tests test_${name})
  endif()

  if(T_SHORT)
    list(JOIN T_SHORT ":" filter)
    list(PREPEND T_PARTS short ${filter} ${T_COST})
  endif()
  set(elsewhere "")   # "-", then the filters of the parts so far
  while(T_PARTS)
    list(POP_FRONT T_PARTS part filter cost)
    dermis_labels(labels ${T_LABEL} ${T_LONG} ${part})
    dermis_test_entry(${name}_${part} ${name} "${labels}" ${cost} "--gtest_filter=${filter}${elsewhere}"
      ${T_ENVIRONMENT})
    if(filter STREQUAL "*")
      return()
    endif()
    if(elsewhere)
      string(APPEND elsewhere ":${filter}")
    else()
      set(elsewhere "-${filter}")
    endif()
  endwhile()
  if(elsewhere)
    set(elsewhere "--gtest_filter=${elsewhere}")
  endif()
  dermis_labels(labels ${T_LABEL} ${T_LONG} "")
  dermis_test_entry(${name} ${name} "${labels}" ${T_COST} "${elsewhere}" ${T_ENVIRONMENT})
endfunction()

function(dermis_script_test name)
  cmake_parse_arguments(T "LONG" "SCRIPT;LABEL;COST" "ARGS" ${ARGN})
  add_test(NAME ${name} COMMAND bash ${CMAKE_CURRENT_SOURCE_DIR}/${T_SCRIPT} ${PROJECT_SOURCE_DIR} ${T_ARGS}
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
  if(NOT T_LABEL)
    set(T_LABEL unit)
  endif()
  if(NOT T_COST)
    set(T_COST 1)
  endif()
  dermis_labels(labels ${T_LABEL} ${T_LONG} "")
  set_tests_properties(${name} PROPERTIES LABELS "${labels}" TIMEOUT 300 COST ${T_COST})
endfunction()
