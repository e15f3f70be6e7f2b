# Makes SuiteSparse::amd, SuiteSparse::camd and SuiteSparse::umfpack, for releases of SuiteSparse without CMake packages
# of their own. The components AMD, CAMD and UMFPACK say which of them are needed.
include(FindPackageHandleStandardArgs)

find_path(SuiteSparse_INCLUDE_DIR amd.h PATH_SUFFIXES suitesparse)
foreach(part ${SuiteSparse_FIND_COMPONENTS})
  string(TOLOWER ${part} name)
  find_library(SuiteSparse_${part}_LIBRARY ${name})
  if(SuiteSparse_INCLUDE_DIR AND SuiteSparse_${part}_LIBRARY)
    set(SuiteSparse_${part}_FOUND TRUE)
    if(NOT TARGET SuiteSparse::${name})
      add_library(SuiteSparse::${name} UNKNOWN IMPORTED)
      set_target_properties(SuiteSparse::${name} PROPERTIES
        IMPORTED_LOCATION "${SuiteSparse_${part}_LIBRARY}"
        INTERFACE_INCLUDE_DIRECTORIES "${SuiteSparse_INCLUDE_DIR}")
    endif()
  endif()
endforeach()

find_package_handle_standard_args(SuiteSparse REQUIRED_VARS SuiteSparse_INCLUDE_DIR HANDLE_COMPONENTS)
