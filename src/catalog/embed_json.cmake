# cmake -DOUTPUT=file.cpp -DROOT=dir "-DFILES=kName=path|kName=path" -P embed_json.cmake
#
# Writes a source file with the bytes of each JSON file as a string constant.
set(text "#include \"catalog/embedded.h\"\n\nnamespace stepmill::embedded {\n")
string(REPLACE "|" ";" files "${FILES}")
foreach(entry IN LISTS files)
  string(REPLACE "=" ";" pair "${entry}")
  list(GET pair 0 name)
  list(GET pair 1 path)
  file(READ "${ROOT}/${path}" content)
  string(APPEND text "\nconst std::string_view ${name} = R\"embedded(${content})embedded\";\n")
endforeach()
string(APPEND text "\n}  // namespace stepmill::embedded\n")
file(WRITE "${OUTPUT}" "${text}")
