# The target `reference`: Doxygen makes pages of the public headers and of the guides, in BUILD/reference/html. A warning fails it.
find_package(Doxygen QUIET)
if(NOT DOXYGEN_FOUND)
  return()
endif()

set(DOXYGEN_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/reference")
set(DOXYGEN_PROJECT_NAME "Sherd")
set(DOXYGEN_PROJECT_BRIEF "Brittle fracture for the Bullet physics engine")
set(DOXYGEN_USE_MDFILE_AS_MAINPAGE "${PROJECT_SOURCE_DIR}/README.md")
set(DOXYGEN_IMAGE_PATH "${PROJECT_SOURCE_DIR}/assets/charts" "${PROJECT_SOURCE_DIR}/assets/pictures")
set(DOXYGEN_HTML_EXTRA_FILES "${PROJECT_SOURCE_DIR}/assets/charts/includes.svg")
set(DOXYGEN_FILTER_PATTERNS "*.md=sed -E -f plugin/cmake/reference.sed")
set(DOXYGEN_USE_MATHJAX YES)
set(DOXYGEN_STRIP_FROM_PATH "${PROJECT_SOURCE_DIR}")
set(DOXYGEN_STRIP_FROM_INC_PATH "${PROJECT_SOURCE_DIR}/include")
set(DOXYGEN_FILE_PATTERNS *.h *.md)
set(DOXYGEN_EXTRACT_ALL YES)
set(DOXYGEN_JAVADOC_AUTOBRIEF YES)  # the first sentence is the summary
set(DOXYGEN_HAVE_DOT NO)
set(DOXYGEN_GENERATE_TREEVIEW YES)
set(DOXYGEN_QUIET YES)
set(DOXYGEN_WARN_AS_ERROR FAIL_ON_WARNINGS)
doxygen_add_docs(reference
  README.md include/sherd assets/README.md assets/docs tests/benchmark/README.md tests/stability/README.md
  tests/data/cases/README.md
  bullet_demos/scenes/README.md bullet_demos/example_browser/README.md
  WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}"
  COMMENT "Making the API reference in ${PROJECT_BINARY_DIR}/reference/html")
