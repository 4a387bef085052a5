/// How many threads the libraries take that factorise and multiply: one each (docs/decisions/0016). OpenBLAS and OpenMP
/// (which MUMPS brings from 5.7 on) read it from the environment once, when they are loaded.
#pragma once

namespace rimpact {

/// Sets what programs started from here on read. True where this process was itself started so.
bool ask_for_one_library_thread();
/// For a program that is linked with them: begins it again where it was not started so. First thing in main.
void begin_with_one_library_thread(char **argv);

} // namespace rimpact
