# Helpers that declare the project's libraries and tests; the allowed arrows between modules stand in their calls.

add_library(deixis_options INTERFACE)
target_compile_options(deixis_options INTERFACE
    -Wall -Wextra -Wpedantic -Wconversion -Wno-sign-conversion -Wnon-virtual-dtor
    # GCC 12 warns falsely on "text" + std::string (GCC bug 105651), in fully optimised builds with more
    # warnings (of std::variant as maybe uninitialised, too).
    $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
    "$<$<AND:$<CXX_COMPILER_ID:GNU>,$<CONFIG:Release>>:-Wno-stringop-overflow;-Wno-array-bounds;-Wno-maybe-uninitialized>"
    # In builds of several files at once (CMAKE_UNITY_BUILD) locals shadow other files' names; dev builds one by one.
    # GCC takes each file but the first for a header, whose types must not have parts from unnamed namespaces.
    $<$<NOT:$<BOOL:${CMAKE_UNITY_BUILD}>>:-Wshadow>
    $<$<AND:$<BOOL:${CMAKE_UNITY_BUILD}>,$<CXX_COMPILER_ID:GNU>>:-Wno-subobject-linkage>
    -ffp-contract=off) # the same arithmetic on every compiler and processor: plans and clips must not depend on it
if(DEIXIS_WERROR)
    target_compile_options(deixis_options INTERFACE -Werror)
endif()
if(DEIXIS_SANITIZE)
    target_compile_options(deixis_options INTERFACE -fsanitize=${DEIXIS_SANITIZE} -fno-omit-frame-pointer
        -fno-sanitize-recover=all)
    target_link_options(deixis_options INTERFACE -fsanitize=${DEIXIS_SANITIZE})
endif()

# Of the tests' code only time to compile is asked; what they test is compiled as the build type says.
set(DEIXIS_TEST_OPTIONS -O0)
include(cmake/building.cmake)

# add_module(NAME [PUBLIC libs...] [PRIVATE libs...])
# A static library deixis::NAME of every src/*.cpp here, with its own include root NAME/include. Only what is linked
# can be included: the allowed arrows between modules stand in these calls.
function(add_module name)
    cmake_parse_arguments(ARG "" "" "PUBLIC;PRIVATE" ${ARGN})
    file(GLOB sources CONFIGURE_DEPENDS src/*.cpp)
    add_library(deixis_${name} STATIC ${sources})
    add_library(deixis::${name} ALIAS deixis_${name})
    target_include_directories(deixis_${name} PUBLIC include PRIVATE src)
    target_link_libraries(deixis_${name} PUBLIC ${ARG_PUBLIC} PRIVATE deixis_options ${ARG_PRIVATE})
    use_precompiled(deixis_${name} deixis_precompiled)
endfunction()

# add_room(NAME [MAIN header.hpp] [ALSO files] [PUBLIC rooms and libs...] [PRIVATE rooms and libs...])
# A part of this folder's module: the folder NAME, a static library deixis::MODULE::NAME of its *.cpp. Its public
# headers stand in NAME/include/MODULE/NAME, which is an include root of its own; private ones beside the sources. Only
# what is linked can be included: the allowed arrows between rooms (written "MODULE/NAME"; every room may use core) stand
# in these calls, and nowhere else. MAIN is the public header that says what the room is for. ALSO: sources that stand in
# folders of their own, each with all that there is of one thing. deixis::MODULE links all rooms of a module.
function(add_room name)
    cmake_parse_arguments(ARG "" "MAIN" "ALSO;PUBLIC;PRIVATE" ${ARGN})
    get_filename_component(module ${CMAKE_CURRENT_SOURCE_DIR} NAME)
    set(target deixis_${module}_${name})
    file(GLOB sources CONFIGURE_DEPENDS ${name}/*.cpp ${ARG_ALSO})
    add_library(${target} STATIC ${sources})
    add_library(deixis::${module}::${name} ALIAS ${target})
    target_include_directories(${target} PUBLIC ${name}/include PRIVATE ${name})
    list(TRANSFORM ARG_PUBLIC REPLACE "^([a-z_]+)/([a-z_]+)$" "deixis::\\1::\\2")
    list(TRANSFORM ARG_PRIVATE REPLACE "^([a-z_]+)/([a-z_]+)$" "deixis::\\1::\\2")
    target_link_libraries(${target} PUBLIC deixis::core ${ARG_PUBLIC} PRIVATE deixis_options ${ARG_PRIVATE})
    use_precompiled(${target} deixis_precompiled)
    if(NOT TARGET deixis_${module})
        add_library(deixis_${module} INTERFACE)
        add_library(deixis::${module} ALIAS deixis_${module})
    endif()
    target_link_libraries(deixis_${module} INTERFACE ${target})
endfunction()

# add_module_tests(NAME FILES ... LIBS libs... LABELS labels...)
# One doctest executable NAME; each TEST_SUITE in FILES becomes one CTest test of that name.
function(add_module_tests name)
    cmake_parse_arguments(ARG "" "" "FILES;LIBS;LABELS" ${ARGN})
    add_executable(${name} ${ARG_FILES} $<TARGET_OBJECTS:deixis_test_main>)
    target_link_libraries(${name} PRIVATE deixis_options doctest::doctest ${ARG_LIBS})
    target_compile_options(${name} PRIVATE ${DEIXIS_TEST_OPTIONS})
    use_precompiled(${name} deixis_precompiled_tests)
    target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
    foreach(file IN LISTS ARG_FILES)
        file(STRINGS ${file} lines REGEX "^TEST_SUITE\\(\"")
        foreach(line IN LISTS lines)
            string(REGEX REPLACE "^TEST_SUITE\\(\"([^\"]+)\"\\).*" "\\1" suite "${line}")
            add_test(NAME ${suite} COMMAND ${name} --test-suite=${suite})
            set_tests_properties(${suite} PROPERTIES LABELS "${ARG_LABELS}" TIMEOUT 900)
            # What libraries keep for each thread the sanitizer notes by reading two words that may not be
            # there: it then crashes at the end of a program that has drawn ("Tracer caught signal 11").
            # Less of what is freed is kept back (256 MB) and told of (30 callers): a tenth to a quarter of the time.
            set(asan intercept_tls_get_addr=0:quarantine_size_mb=8:malloc_context_size=8)
            if("gl" IN_LIST ARG_LABELS OR "program" IN_LIST ARG_LABELS)
                # What graphics drivers leave allocated is not ours to report. Tests of whole commands start the
                # program some thousand times, a fifth of each start being the search for leaks, which the
                # libraries' own tests do.
                string(APPEND asan ":detect_leaks=0")
            endif()
            set_tests_properties(${suite} PROPERTIES ENVIRONMENT "ASAN_OPTIONS=${asan}")
        endforeach()
    endforeach()
endfunction()
