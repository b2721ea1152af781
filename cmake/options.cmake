# sailmap_options(target): warnings as errors and sanitizers, as properties of the target.
function(sailmap_options target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wconversion -Wshadow)
  if(SAILMAP_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  if(SAILMAP_SANITIZE)
    target_compile_options(${target} PRIVATE -fsanitize=${SAILMAP_SANITIZE} -fno-sanitize-recover=all
                                             -fno-omit-frame-pointer)
    target_link_options(${target} PUBLIC -fsanitize=${SAILMAP_SANITIZE})
  endif()
endfunction()
