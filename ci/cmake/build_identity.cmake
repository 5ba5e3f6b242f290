# Writes what the program was built from, as a source file; leaves the file alone if nothing changed.
# cmake -D SOURCE_DIR=... -D OUTPUT=... -D VERSION=... -D COMPILER=... -D FLAGS=... -P build_identity.cmake
set(git_state "unknown")
find_program(GIT git)
if(GIT)
  execute_process(COMMAND ${GIT} -C ${SOURCE_DIR} describe --always --dirty --abbrev=12 --exclude=*
                  OUTPUT_VARIABLE described OUTPUT_STRIP_TRAILING_WHITESPACE
                  RESULT_VARIABLE failed ERROR_QUIET)
  if(NOT failed)
    set(git_state "${described}")
  endif()
endif()

# The sources that decide numbers.
file(GLOB_RECURSE sources RELATIVE ${SOURCE_DIR}
     ${SOURCE_DIR}/reference/*.?pp ${SOURCE_DIR}/solver/*.?pp
     ${SOURCE_DIR}/verification/norms.?pp ${SOURCE_DIR}/verification/field_errors.?pp
     ${SOURCE_DIR}/verification/wave_measures/*.?pp
     ${SOURCE_DIR}/verification/run.?pp ${SOURCE_DIR}/verification/grade/*.?pp)
list(FILTER sources EXCLUDE REGEX "_(test|fixtures|skeleton)\\.|/digits/|/tables/")
list(SORT sources)
set(content "${COMPILER}\n${FLAGS}\n")
foreach(source ${sources})
  file(SHA256 ${SOURCE_DIR}/${source} hash)
  string(APPEND content "${source} ${hash}\n")
endforeach()
string(SHA256 numerics "${content}")

file(CONFIGURE OUTPUT ${OUTPUT} @ONLY CONTENT [[
#include "verification/study/build_identity.hpp"

namespace porowave::verification {

std::string_view program_version() {
  return "@VERSION@";
}
std::string_view git_state() {
  return "@git_state@";
}
std::string_view compiler() {
  return "@COMPILER@";
}
std::string_view compiler_flags() {
  return "@FLAGS@";
}
std::string_view numerics_hash() {
  return "@numerics@";
}

}  // namespace porowave::verification
]])
