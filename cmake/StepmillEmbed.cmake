# stepmill_embed(OUTPUT HEADER NAMESPACE kName=path...)
#
# Makes the source file OUTPUT, which defines the constants that HEADER declares in NAMESPACE: the bytes of each file
# (its path is absolute or relative to the project), so that the program runs from any folder.
set(STEPMILL_EMBED_SCRIPT ${CMAKE_CURRENT_LIST_DIR}/embed_files.cmake)
function(stepmill_embed output header namespace)
  foreach(entry ${ARGN})
    string(REGEX REPLACE "^[^=]*=" "" path "${entry}")
    get_filename_component(path "${path}" ABSOLUTE BASE_DIR ${CMAKE_SOURCE_DIR})
    list(APPEND paths ${path})
  endforeach()
  string(REPLACE ";" "|" files "${ARGN}")
  add_custom_command(
    OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -DOUTPUT=${output} -DHEADER=${header} -DNAMESPACE=${namespace} -DROOT=${CMAKE_SOURCE_DIR}
            "-DFILES=${files}" -P ${STEPMILL_EMBED_SCRIPT}
    DEPENDS ${paths} ${STEPMILL_EMBED_SCRIPT}
    COMMENT "Embedding files into ${namespace}"
    VERBATIM)
endfunction()
