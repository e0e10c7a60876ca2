# The libraries of Open CASCADE that CAD files are read with. Its own package configuration wants
# packages of everything else (pictures, its test program).
# Defines the imported target OCCT::OCCT.
find_path(OCCT_INCLUDE_DIR Standard_Version.hxx PATH_SUFFIXES opencascade)
set(occt_libraries)
set(occt_needed OCCT_INCLUDE_DIR)
foreach(part TKIGES TKSTEP TKSTEPBase TKXSBase TKTopAlgo TKGeomBase TKBRep TKG3d TKG2d TKMath TKernel)
    find_library(OCCT_${part}_LIBRARY ${part})
    list(APPEND occt_libraries "${OCCT_${part}_LIBRARY}")
    list(APPEND occt_needed OCCT_${part}_LIBRARY)
endforeach()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(OCCT REQUIRED_VARS ${occt_needed}
    REASON_FAILURE_MESSAGE
    "Open CASCADE reads CAD files: install libocct-data-exchange-dev, or configure with -DHEXWEAVE_CAD=OFF.")
if(OCCT_FOUND AND NOT TARGET OCCT::OCCT)
    add_library(OCCT::OCCT INTERFACE IMPORTED)
    target_include_directories(OCCT::OCCT SYSTEM INTERFACE "${OCCT_INCLUDE_DIR}")
    target_link_libraries(OCCT::OCCT INTERFACE ${occt_libraries})
endif()
