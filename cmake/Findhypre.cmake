# Debian's libhypre-dev ships neither a package configuration nor a pkg-config file, and its headers
# include those of MPI. Defines the imported target hypre::hypre.
find_package(MPI QUIET COMPONENTS C)
find_path(HYPRE_INCLUDE_DIR HYPRE.h PATH_SUFFIXES hypre)
find_library(HYPRE_LIBRARY HYPRE)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(hypre REQUIRED_VARS HYPRE_LIBRARY HYPRE_INCLUDE_DIR MPI_C_FOUND)
if(hypre_FOUND AND NOT TARGET hypre::hypre)
    add_library(hypre::hypre UNKNOWN IMPORTED)
    set_target_properties(hypre::hypre PROPERTIES
        IMPORTED_LOCATION "${HYPRE_LIBRARY}" INTERFACE_INCLUDE_DIRECTORIES "${HYPRE_INCLUDE_DIR}"
        INTERFACE_COMPILE_DEFINITIONS "OMPI_SKIP_MPICXX;MPICH_SKIP_MPICXX"
        INTERFACE_LINK_LIBRARIES MPI::MPI_C)
endif()
