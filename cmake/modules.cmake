# Helpers that declare the project's libraries and tests; the allowed arrows between modules stand in their calls.

add_library(deixis_options INTERFACE)
target_compile_options(deixis_options INTERFACE
    -Wall -Wextra -Wpedantic -Wconversion -Wno-sign-conversion -Wnon-virtual-dtor
    # GCC 12 warns falsely on "text" + std::string (GCC bug 105651), in fully optimised builds with more warnings.
    $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
    "$<$<AND:$<CXX_COMPILER_ID:GNU>,$<CONFIG:Release>>:-Wno-stringop-overflow;-Wno-array-bounds>"
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
endfunction()

# Of the tests' code only time to compile is asked; what they test is compiled as the build type says.
set(DEIXIS_TEST_OPTIONS -O0)

# add_module_tests(NAME FILES ... LIBS libs... LABELS labels...)
# One doctest executable NAME; each TEST_SUITE in FILES becomes one CTest test of that name.
function(add_module_tests name)
    cmake_parse_arguments(ARG "" "" "FILES;LIBS;LABELS" ${ARGN})
    add_executable(${name} ${ARG_FILES} $<TARGET_OBJECTS:deixis_test_main>)
    target_link_libraries(${name} PRIVATE deixis_options doctest::doctest ${ARG_LIBS})
    target_compile_options(${name} PRIVATE ${DEIXIS_TEST_OPTIONS})
    target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
    target_compile_definitions(${name} PRIVATE
        DEIXIS_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
        DEIXIS_BINARY_DIR="${PROJECT_BINARY_DIR}"
        DEIXIS_SHARED_DATA="${PROJECT_SOURCE_DIR}/../shared/data")
    foreach(file IN LISTS ARG_FILES)
        file(STRINGS ${file} lines REGEX "^TEST_SUITE\\(\"")
        foreach(line IN LISTS lines)
            string(REGEX REPLACE "^TEST_SUITE\\(\"([^\"]+)\"\\).*" "\\1" suite "${line}")
            add_test(NAME ${suite} COMMAND ${name} --test-suite=${suite})
            set_tests_properties(${suite} PROPERTIES LABELS "${ARG_LABELS}" TIMEOUT 900)
            # What libraries keep for each thread the sanitizer notes by reading two words that may not be
            # there: it then crashes at the end of a program that has drawn ("Tracer caught signal 11").
            set(asan intercept_tls_get_addr=0)
            if("gl" IN_LIST ARG_LABELS)
                # What graphics drivers leave allocated is not ours to report.
                string(APPEND asan ":detect_leaks=0")
            endif()
            set_tests_properties(${suite} PROPERTIES ENVIRONMENT "ASAN_OPTIONS=${asan}")
        endforeach()
    endforeach()
endfunction()
