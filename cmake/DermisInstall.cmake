# SPDX-License-Identifier: MIT
# dermis_install()
#   What find_package(dermis) needs: the public headers, the static libraries behind dermis_api (found by
#   following their links, so that a new room joins by itself), and the package files. All in the component
#   "development". The target to link is dermis::dermis, or dermis::draw for what draws arrays alone. A room
#   that brings in a new outside library adds it to dermisConfig.cmake.in.
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
  add_library(dermis::dermis ALIAS dermis_api)
  add_library(dermis::draw ALIAS dermis_api_draw)
  set_target_properties(dermis_api PROPERTIES EXPORT_NAME dermis)
  set_target_properties(dermis_api_draw PROPERTIES EXPORT_NAME draw)
  foreach(library api api_draw)
    target_compile_features(dermis_${library} INTERFACE cxx_std_20)
    target_include_directories(dermis_${library} INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  endforeach()

  set(rooms "")
  dermis_rooms_behind(dermis_api rooms)
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
