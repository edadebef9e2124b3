# stepmill_module(NAME SOURCES ... DEPENDS modules ... LIBRARIES targets ...)
#
# One static library `stepmill_<name>` per module. DEPENDS are modules above it in the data flow and are
# public, since their types stand in this module's headers; LIBRARIES stay private. Modules that use
# nlohmann_json share the precompiled header with it, the others the one without.
function(stepmill_module name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS;LIBRARIES" ${ARGN})
  set(target stepmill_${name})
  add_library(${target} STATIC ${ARG_SOURCES})
  add_library(stepmill::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  target_include_directories(${target}
    PUBLIC $<BUILD_INTERFACE:${CMAKE_SOURCE_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
    PRIVATE ${CMAKE_SOURCE_DIR}/src)
  target_link_libraries(${target} PUBLIC Eigen3::Eigen PRIVATE $<BUILD_INTERFACE:stepmill_warnings> ${ARG_LIBRARIES})
  foreach(module ${ARG_DEPENDS})
    target_link_libraries(${target} PUBLIC stepmill_${module})
  endforeach()
  if(nlohmann_json::nlohmann_json IN_LIST ARG_LIBRARIES)
    target_precompile_headers(${target} REUSE_FROM stepmill_precompiled_json)
  else()
    target_precompile_headers(${target} REUSE_FROM stepmill_precompiled)
  endif()
endfunction()
