# Writes OUTPUT, a C++ source that tells from which commit SOURCE is built, and leaves it alone where it says so already:
# then nothing is compiled anew. Sources that are no clone, such as an archive, are of an unknown commit.
set(commit "unknown")
set(changes "unknown")
find_package(Git QUIET)
if(GIT_FOUND)
    execute_process(COMMAND ${GIT_EXECUTABLE} rev-parse --show-toplevel HEAD WORKING_DIRECTORY ${SOURCE}
        OUTPUT_VARIABLE found OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
    string(REGEX MATCH "^([^\n]+)\n([0-9a-f]+)$" is_clone "${found}")
    set(top "${CMAKE_MATCH_1}")
    set(head "${CMAKE_MATCH_2}")
    file(REAL_PATH "${SOURCE}" source)
    # An archive unpacked in somebody's clone is not of that clone's commit.
    if(NOT failed AND is_clone AND top STREQUAL source)
        set(commit "${head}")
        execute_process(COMMAND ${GIT_EXECUTABLE} status --porcelain --untracked-files=no
            WORKING_DIRECTORY ${SOURCE} OUTPUT_VARIABLE changed ERROR_QUIET RESULT_VARIABLE failed)
        if(NOT failed)
            set(changes "no")
            if(NOT changed STREQUAL "")
                set(changes "yes")
            endif()
        endif()
    endif()
endif()
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT [[// Made by cmake/commit.cmake.
namespace deixis::app {
extern const char* const built_from_commit;
extern const char* const built_with_changes;
const char* const built_from_commit = "@commit@";
const char* const built_with_changes = "@changes@";
}  // namespace deixis::app
]] @ONLY)
