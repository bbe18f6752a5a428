# Fails where `program` needs a library for rendering: a check needs none.
file(GET_RUNTIME_DEPENDENCIES EXECUTABLES "${program}" RESOLVED_DEPENDENCIES_VAR libraries
     UNRESOLVED_DEPENDENCIES_VAR missing)
list(APPEND libraries ${missing})
list(FILTER libraries INCLUDE REGEX "embree|OpenImageIO|CGAL|mpfr|gmp")
if(libraries)
  message(FATAL_ERROR "${program} needs ${libraries}")
endif()
