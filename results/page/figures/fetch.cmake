# What draws the reports' figures. Included by the build; `cmake -P results/page/figures/fetch.cmake` does it alone.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/../../../cmake/npm.cmake)
fetch_npm(${CMAKE_CURRENT_LIST_DIR} "what draws the reports' figures" LIBRARIES esbuild vega vega-lite vega-embed)
