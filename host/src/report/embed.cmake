# Turns the page's sources into C++: cmake -DSOURCES=share/report -DOUT=page_sources.cpp -P embed.cmake
# The scripts are ES modules; on the page they are one, so that lines of import go, and `export` before a declaration.
set(modules dom format colours store zoom graph_draw map_view pair loops timeline matrix curve saliency details summary live main)

function(read_source out name)
  file(READ ${SOURCES}/${name} text)
  set(${out} "${text}" PARENT_SCOPE)
endfunction()

read_source(markup page.html)
read_source(style style.css)
set(script "\"use strict\";\n")
foreach(module ${modules})
  read_source(text ${module}.js)
  string(REGEX REPLACE "(^|\n)import [^\n]*;" "\\1" text "${text}")
  string(REGEX REPLACE "(^|\n)export " "\\1" text "${text}")
  string(APPEND script "${text}")
endforeach()

set(code "#include \"report/page_sources.hpp\"\n\nnamespace sailmap::report {\n")
foreach(part markup style script)
  string(APPEND code "\nstd::string_view page_${part}() {\n  return R\"sailmap_page(${${part}})sailmap_page\";\n}\n")
endforeach()
string(APPEND code "\n}  // namespace sailmap::report\n")
file(WRITE ${OUT} "${code}")
