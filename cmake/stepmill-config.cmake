# What find_package(stepmill) reads: the libraries that Stepmill's own link to, then its targets.
include(CMakeFindDependencyMacro)
find_dependency(Threads)
find_dependency(Eigen3 NO_MODULE)
find_dependency(TBB)
find_dependency(fmt)
find_dependency(nlohmann_json)
find_dependency(SQLite3)
include(${CMAKE_CURRENT_LIST_DIR}/stepmill-targets.cmake)
