# Text files built into the program: embed_text(OUTPUT NAMESPACE HEADER FILE...) writes a C++ source
# that defines, in the namespace, a string_view for every file, called after it (page.html:
# page_html). Run again when a file changes.
function(embed_text OUTPUT NAMESPACE HEADER)
    set(source "// Written by cmake/EmbedText.cmake.\n#include \"${HEADER}\"\n\nnamespace ${NAMESPACE} {\n")
    foreach(file ${ARGN})
        set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
        file(READ ${file} text)
        get_filename_component(name ${file} NAME)
        string(REPLACE "." "_" name ${name})
        string(APPEND source "const std::string_view ${name} = R\"~embedded~(${text})~embedded~\";\n")
    endforeach()
    string(APPEND source "}  // namespace ${NAMESPACE}\n")
    file(CONFIGURE OUTPUT ${OUTPUT} CONTENT "@source@" @ONLY)
endfunction()
