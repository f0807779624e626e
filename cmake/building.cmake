# What makes building quicker: headers compiled once, and a compiler cache and a quick linker where they are installed.

option(DEIXIS_PCH "Compile the headers that most files read once for all of them" ON)

find_program(DEIXIS_CCACHE ccache)
if(DEIXIS_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    # Two clones share what they compile, and precompiled headers count by what is in them.
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_NOHASHDIR=1
        CCACHE_SLOPPINESS=pch_defines,time_macros ${DEIXIS_CCACHE})
endif()
find_program(DEIXIS_MOLD mold)
if(DEIXIS_MOLD)
    add_link_options(-fuse-ld=mold)
endif()

# add_precompiled(NAME [options...]): cmake/precompiled.hpp, compiled as the project's sources are and with the options.
function(add_precompiled name)
    add_library(${name} OBJECT ${PROJECT_SOURCE_DIR}/cmake/precompiled.cpp)
    target_link_libraries(${name} PRIVATE deixis_options fmt::fmt glm::glm tl::expected nlohmann_json::nlohmann_json)
    target_compile_definitions(${name} PRIVATE $<$<CONFIG:Release>:GLM_FORCE_INLINE>) # as core has it
    target_compile_options(${name} PRIVATE ${ARGN} $<$<CXX_COMPILER_ID:Clang>:SHELL:-Xclang -fno-pch-timestamp>)
    target_precompile_headers(${name} PRIVATE ${PROJECT_SOURCE_DIR}/cmake/precompiled.hpp)
endfunction()

if(DEIXIS_PCH)
    find_package(fmt REQUIRED)
    find_package(glm REQUIRED)
    find_package(tl-expected REQUIRED)
    find_package(nlohmann_json REQUIRED)
    add_precompiled(deixis_precompiled)
    add_precompiled(deixis_precompiled_tests ${DEIXIS_TEST_OPTIONS})
endif()

# use_precompiled(TARGET FROM): the target's sources read what add_precompiled made.
function(use_precompiled target from)
    if(DEIXIS_PCH)
        target_precompile_headers(${target} REUSE_FROM ${from})
    endif()
endfunction()
