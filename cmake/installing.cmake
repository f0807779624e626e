# cmake --install BUILD --prefix P. The program finds what ships from its own place, bin/deixis: P may be moved.
install(TARGETS deixis DESTINATION bin)
if(DEIXIS_LEARNING)
    install(TARGETS deixis-train DESTINATION bin)
endif()
install(DIRECTORY assets/data/ DESTINATION share/deixis PATTERN *.cpp EXCLUDE PATTERN include EXCLUDE)
install(FILES ${DEIXIS_SHARE}/avatar.glb DESTINATION share/deixis)
if(DEIXIS_STUDIO)
    install(DIRECTORY ${DEIXIS_SHARE}/studio DESTINATION share/deixis)
endif()
install(DIRECTORY docs/ DESTINATION share/doc/deixis)
install(FILES LICENSE DESTINATION share/doc/deixis)

if(DEIXIS_IMMERSIVE)
    foreach(font REGULAR BOLD HANGUL_REGULAR HANGUL_BOLD)
        string(TOLOWER ${font}.ttf name)
        install(FILES ${DEIXIS_FONT_${font}} DESTINATION share/deixis/fonts RENAME ${name})
    endforeach()
    # As Debian tells them; who took other fonts adds theirs.
    foreach(package fonts-open-sans fonts-nanum)
        install(FILES /usr/share/doc/${package}/copyright DESTINATION share/doc/deixis/licences RENAME ${package}
            OPTIONAL)
    endforeach()
endif()

# The program describes itself.
set(manual ${PROJECT_BINARY_DIR}/share/man/man1/deixis.1)
set(completion ${PROJECT_BINARY_DIR}/share/bash-completion/completions/deixis)
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/share/man/man1 ${PROJECT_BINARY_DIR}/share/bash-completion/completions)
install(FILES ${manual} DESTINATION share/man/man1)
install(FILES ${completion} DESTINATION share/bash-completion/completions)
