# Writes OUTPUT with one SHA-256 of all sources that shape a result, only when it changed, so that an edit rebuilds one small file.
# Not the commit: that changes with the docs and the report too, and not with an edit that is not committed.
set(all "")
foreach(module io laws scene responses reduced_models buildings meshes fe_contact)
  file(GLOB_RECURSE sources RELATIVE ${SOURCE} ${SOURCE}/${module}/*.cc ${SOURCE}/${module}/*.h)
  list(SORT sources)
  foreach(source IN LISTS sources)
    file(SHA256 ${SOURCE}/${source} hash)
    string(APPEND all "${source} ${hash}\n")
  endforeach()
endforeach()
string(SHA256 hash "${all}")
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT "#pragma once\n#define RIMPACT_PHYSICS \"${hash}\"\n")
