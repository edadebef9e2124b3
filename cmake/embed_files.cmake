# cmake -DOUTPUT=file.cpp -DHEADER=module/embedded.h -DNAMESPACE=stepmill::module -DROOT=dir
#       "-DFILES=kName=path|kName=path" -P embed_files.cmake
#
# Writes a source file with the bytes of each file as a string constant; see StepmillEmbed.cmake.
# A library's script is longer than a standard promises of a string; both compilers take it.
set(text "#pragma GCC diagnostic ignored \"-Woverlength-strings\"\n#include \"${HEADER}\"\n\nnamespace ${NAMESPACE} {\n")
string(REPLACE "|" ";" files "${FILES}")
foreach(entry IN LISTS files)
  string(REPLACE "=" ";" pair "${entry}")
  list(GET pair 0 name)
  list(GET pair 1 path)
  get_filename_component(path "${path}" ABSOLUTE BASE_DIR "${ROOT}")
  file(READ "${path}" content)
  string(APPEND text "\nconst std::string_view ${name} = R\"embedded(${content})embedded\";\n")
endforeach()
string(APPEND text "\n}  // namespace ${NAMESPACE}\n")
file(WRITE "${OUTPUT}" "${text}")
