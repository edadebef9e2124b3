# Every library comes from Debian 12 packages; scripts/install-dependencies lists them.
find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM)
  # Without these ccache leaves alone whatever is built with a precompiled header, which is every source here.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${CCACHE_PROGRAM})
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    add_compile_options(-fpch-preprocess)
  else()
    add_compile_options("SHELL:-Xclang -fno-pch-timestamp")
  endif()
endif()

find_package(Threads REQUIRED)
find_package(Eigen3 REQUIRED NO_MODULE)
find_package(GEOS REQUIRED)
find_package(TBB REQUIRED)
find_package(fmt REQUIRED)
find_package(CLI11 REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(SQLite3 REQUIRED)
# What the viewer of the report is drawn with; it stands in the page.
find_path(THREE_JS_DIR build/three.min.js HINTS /usr/share/javascript/three REQUIRED NO_CACHE)
find_path(VALIJSON_INCLUDE_DIR valijson/validator.hpp REQUIRED)

# zip and XML of other programs' files.
find_path(ZIP_INCLUDE_DIR zip.h REQUIRED)
find_library(ZIP_LIBRARY zip REQUIRED)
find_path(PUGIXML_INCLUDE_DIR pugixml.hpp REQUIRED)
find_library(PUGIXML_LIBRARY pugixml REQUIRED)
# Drawings.
find_path(DXFLIB_INCLUDE_DIR dxflib/dl_dxf.h REQUIRED)
find_library(DXFLIB_LIBRARY dxflib REQUIRED)

# GEOS' C++ interface (OverlayNG, index trees) lives in libgeos beside the C one.
find_library(GEOS_CXX_LIBRARY geos REQUIRED)
add_library(stepmill_geos INTERFACE)
target_link_libraries(stepmill_geos INTERFACE ${GEOS_CXX_LIBRARY})
target_compile_definitions(stepmill_geos INTERFACE USE_UNSTABLE_GEOS_CPP_API)

# OCCT's own package file drags in its visualisation tool kits; only these are needed.
find_path(OCCT_INCLUDE_DIR Standard_Version.hxx PATH_SUFFIXES opencascade REQUIRED)
add_library(stepmill_occt INTERFACE)
target_include_directories(stepmill_occt SYSTEM INTERFACE ${OCCT_INCLUDE_DIR})
foreach(toolkit TKSTEP TKSTEPBase TKSTEPAttr TKSTEP209 TKXSBase TKHLR TKOffset TKFillet TKBool TKBO
        TKShHealing TKMesh TKPrim TKTopAlgo TKGeomAlgo TKBRep TKGeomBase TKG3d TKG2d TKMath TKernel)
  find_library(OCCT_${toolkit} ${toolkit} REQUIRED)
  target_link_libraries(stepmill_occt INTERFACE ${OCCT_${toolkit}})
endforeach()

add_library(stepmill_warnings INTERFACE)
target_compile_options(stepmill_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual -Wnull-dereference -Werror
  # GCC 12 reports these in Eigen and the standard library under -O2, in code that is right, and dozens of them where
  # code may lie anywhere in memory. Clang, clang-tidy and the sanitizers look for the same.
  $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized -Wno-null-dereference -Wno-array-bounds -Wno-restrict
  -Wno-stringop-overflow>)
if(CMAKE_UNITY_BUILD)
  # To GCC each joined source is a header, whose types may not hold those of an unnamed namespace.
  target_compile_options(stepmill_warnings INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
endif()
if(STEPMILL_SANITIZE)
  # What is undefined ends the test instead of printing a line nobody reads.
  add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
  add_compile_definitions(STEPMILL_SANITIZED)
  add_link_options(-fsanitize=address,undefined)
endif()
if(STEPMILL_FUZZ)
  add_compile_options(-fsanitize=fuzzer-no-link)
endif()

# The standard headers nearly every file needs, compiled once for all modules.
set(STEPMILL_PRECOMPILED
  <algorithm> <cmath> <functional> <map> <memory> <optional> <set> <span> <string> <vector> <Eigen/Geometry>)
