/// Limits of a process that reads foreign files.
#pragma once

namespace rimpact::meshes {

/// From now on this process starts no program, opens no file for writing and no socket, removes nothing, and ends after
/// `cpu_seconds` or beyond `memory_bytes` of address space. False where the kernel offers no system-call filter
/// (seccomp): then only the two limits hold.
bool confine(unsigned long cpu_seconds, unsigned long memory_bytes);

} // namespace rimpact::meshes
