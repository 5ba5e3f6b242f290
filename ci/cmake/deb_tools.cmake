# Read by cpack before it starts. Without these tools it would make a package without dependencies
# and say so only in passing.
if(CPACK_GENERATOR STREQUAL "DEB")
  foreach(tool dpkg-shlibdeps file)
    find_program(found_${tool} ${tool})
    if(NOT found_${tool})
      message(FATAL_ERROR "${tool} is missing, run ci/install-deps.sh --package")
    endif()
  endforeach()
endif()
