# What the studio's page is made of, without what only its tests need. Included by the build.
include(${CMAKE_CURRENT_LIST_DIR}/../cmake/npm.cmake)
fetch_npm(${CMAKE_CURRENT_LIST_DIR} "what the studio's page is made of"
    LIBRARIES esbuild immer preact @preact/signals three wavesurfer.js mediabunny OPTIONS --omit=dev)
