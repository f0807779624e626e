# Makes the studio's page of src/ and the libraries: scripts, styles, and the licences of what is in them.
#   cmake -DFOLDER=web -DOUT=share/deixis/studio -P bundle.cmake
set(modules ${FOLDER}/node_modules)

# npm has fetched the program for this machine alone; it needs no node.
file(GLOB esbuild ${modules}/@esbuild/*/bin/esbuild)
file(REMOVE_RECURSE ${OUT}) # scripts that come later have their content's hash in their names
execute_process(COMMAND ${esbuild} studio=src/main.tsx studio=src/styles/studio.css --bundle --splitting --format=esm --minify
        --target=es2022 --jsx=automatic --jsx-import-source=preact --legal-comments=none --log-level=warning --outdir=${OUT}
    WORKING_DIRECTORY ${FOLDER} COMMAND_ERROR_IS_FATAL ANY)
file(COPY ${FOLDER}/src/index.html ${FOLDER}/src/icon.svg DESTINATION ${OUT})

# The avatar's script, and what it shares with the first one, are asked for at once, not when the first one has been read.
file(GLOB later RELATIVE ${OUT} ${OUT}/avatar_view-*.js ${OUT}/chunk-*.js)
file(READ ${OUT}/index.html page)
set(first "<link rel=\"modulepreload\" href=\"/studio.js\">")
set(links ${first})
foreach(script ${later})
    string(APPEND links "\n<link rel=\"modulepreload\" href=\"/${script}\">")
endforeach()
string(REPLACE "${first}" "${links}" page "${page}")
file(WRITE ${OUT}/index.html "${page}")

set(notice "The studio's page is built with the following libraries.\n")
foreach(library preact @preact/signals @preact/signals-core immer three wavesurfer.js mediabunny)
    file(READ ${modules}/${library}/package.json description)
    string(JSON version GET "${description}" version)
    file(GLOB licence ${modules}/${library}/LICENSE*)
    if(NOT licence)
        message(FATAL_ERROR "The licence of ${library} is not where npm puts it.")
    endif()
    file(READ ${licence} text)
    string(APPEND notice "\n${library} ${version}\n\n${text}\n")
endforeach()
file(WRITE ${OUT}/licences.txt "${notice}")
