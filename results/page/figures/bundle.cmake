# Makes one script of page.js, the libraries that draw the figures and their licences, that can stand in a page, in HTML
# and in XML alike:
#   cmake -DFOLDER=results/page/figures -DOUT=figures.js -P bundle.cmake
set(modules ${FOLDER}/node_modules)

# npm has fetched the program for this machine alone; it needs no node.
file(GLOB esbuild ${modules}/@esbuild/*/bin/esbuild)
execute_process(COMMAND ${esbuild} page.js --bundle --minify --legal-comments=none --log-level=warning
    WORKING_DIRECTORY ${FOLDER} OUTPUT_VARIABLE script COMMAND_ERROR_IS_FATAL ANY)

# Each licence once, below the names of those that have it.
file(GLOB licences ${modules}/vega*/LICENSE* ${modules}/d3-*/LICENSE* ${modules}/topojson-client/LICENSE*
    ${modules}/delaunator/LICENSE* ${modules}/robust-predicates/LICENSE* ${modules}/internmap/LICENSE*
    ${modules}/semver/LICENSE* ${modules}/fast-json-patch/LICENSE* ${modules}/json-stringify-pretty-compact/LICENSE*
    ${modules}/tslib/LICENSE*)
list(SORT licences)
set(known "")
foreach(licence IN LISTS licences)
    file(READ ${licence} text)
    string(REPLACE "\r" "" text "${text}")
    string(STRIP "${text}" text)
    string(SHA256 hash "${text}")
    get_filename_component(name ${licence} DIRECTORY)
    get_filename_component(name ${name} NAME)
    file(READ ${modules}/${name}/package.json description)
    string(JSON version GET "${description}" version)
    list(APPEND known ${hash})
    set(text_${hash} "${text}")
    string(APPEND names_${hash} "${name} ${version}\n")
endforeach()
list(REMOVE_DUPLICATES known)
set(notice "The figures are drawn by the following libraries, which stand below.\n")
foreach(hash IN LISTS known)
    string(APPEND notice "\n${names_${hash}}\n${text_${hash}}\n")
endforeach()

# What would end the element, in XML or in HTML, must not stand in it. In a script "]]>" is two brackets and a greater.
string(REPLACE "]]>" "]] >" script "${script}")
string(TOLOWER "${notice}${script}" lower)
foreach(forbidden "</script" "<!--" "]]>")
    string(FIND "${lower}" "${forbidden}" at)
    if(NOT at EQUAL -1)
        message(FATAL_ERROR "The libraries that draw the figures contain ${forbidden}, which cannot stand in a page.")
    endif()
endforeach()
string(FIND "${notice}" "*/" at)
if(NOT at EQUAL -1)
    message(FATAL_ERROR "A licence of the libraries that draw the figures would end its comment.")
endif()
file(WRITE ${OUT} "/*!\n${notice}*/\n${script}")
