# SPDX-License-Identifier: MIT
# dermis_install()
#   What find_package(dermis) needs: the public headers, the static libraries behind dermis_api (found by
#   following their links, so that a new room joins by itself), and the package files. All in the component
#   "development". The targets to link are dermis::dermis, dermis::draw for what draws arrays alone, and
#   dermis::dataset for dermis/dataset.h. A room that brings in a new outside
#   library adds it to dermisConfig.cmake.in.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

function(dermis_rooms_behind target result)
  set(found ${${result}} ${target})
  get_target_property(type ${target} TYPE)
  set(links INTERFACE_LINK_LIBRARIES)
  if(NOT type STREQUAL "INTERFACE_LIBRARY")
    list(APPEND links LINK_LIBRARIES)
  endif()
  foreach(property IN LISTS links)
    get_target_property(libraries ${target} ${property})
    foreach(library IN LISTS libraries)
      if(library MATCHES "^dermis_" AND NOT library IN_LIST found)
        set(inner ${found})
        dermis_rooms_behind(${library} inner)
        set(found ${inner})
      endif()
    endforeach()
  endforeach()
  set(${result} ${found} PARENT_SCOPE)
endfunction()

function(dermis_install)
  foreach(door IN ITEMS dermis/api draw/api_draw dataset/dataset)
    get_filename_component(name ${door} DIRECTORY)
    get_filename_component(room ${door} NAME)
    add_library(dermis::${name} ALIAS dermis_${room})
    set_target_properties(dermis_${room} PROPERTIES EXPORT_NAME ${name})
    target_compile_features(dermis_${room} INTERFACE cxx_std_20)
    target_include_directories(dermis_${room} INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  endforeach()

  set(rooms "")
  dermis_rooms_behind(dermis_api rooms)
  dermis_rooms_behind(dermis_dataset rooms)
  set(folder ${CMAKE_INSTALL_LIBDIR}/cmake/dermis)
  install(TARGETS ${rooms} EXPORT dermis ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
  install(EXPORT dermis NAMESPACE dermis:: FILE dermisTargets.cmake DESTINATION ${folder}
    COMPONENT development)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/dermis DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
    COMPONENT development
    FILES_MATCHING PATTERN "*.h" PATTERN "*.glsl")
  configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/dermisConfig.cmake.in
    ${PROJECT_BINARY_DIR}/package/dermisConfig.cmake
    INSTALL_DESTINATION ${folder})
  # Before 1.0 a minor version may change what callers wrote.
  write_basic_package_version_file(${PROJECT_BINARY_DIR}/package/dermisConfigVersion.cmake
    COMPATIBILITY SameMinorVersion)
  install(FILES ${PROJECT_BINARY_DIR}/package/dermisConfig.cmake
    ${PROJECT_BINARY_DIR}/package/dermisConfigVersion.cmake
    DESTINATION ${folder} COMPONENT development)
endfunction()
