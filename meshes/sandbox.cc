#include "meshes/sandbox.h"

#include <cerrno>
#include <cstddef>
#include <fcntl.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <vector>

namespace rimpact::meshes {
namespace {

#if defined(__x86_64__)
constexpr unsigned architecture = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr unsigned architecture = AUDIT_ARCH_AARCH64;
#else
constexpr unsigned architecture = 0;
#endif

constexpr unsigned refused = SECCOMP_RET_ERRNO | EPERM, unknown = SECCOMP_RET_ERRNO | ENOSYS;

/// A filter is a program of its own: load a word of the call, compare, answer.
class Filter {
public:
  Filter() {
    load(offsetof(seccomp_data, arch));
    code_.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, architecture, 1, 0));
    answer(SECCOMP_RET_KILL_PROCESS);
#ifdef __X32_SYSCALL_BIT // a second numbering of the same calls
    load(offsetof(seccomp_data, nr));
    code_.push_back(BPF_JUMP(BPF_JMP | BPF_JGE | BPF_K, __X32_SYSCALL_BIT, 0, 1));
    answer(SECCOMP_RET_KILL_PROCESS);
#endif
  }
  void refuse(long call, unsigned with = refused) {
    load(offsetof(seccomp_data, nr));
    code_.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, static_cast<unsigned>(call), 0, 1));
    answer(with);
  }
  /// Where argument `index` (from 0) has any of `bits`, or, `when_set` false, has none of them.
  void refuse_bits(long call, int index, unsigned bits, bool when_set = true) {
    load(offsetof(seccomp_data, nr));
    code_.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, static_cast<unsigned>(call), 0, 3));
    load(offsetof(seccomp_data, args) + 8 * index); // the lower half: flags fit into it
    code_.push_back(BPF_JUMP(BPF_JMP | BPF_JSET | BPF_K, bits, static_cast<unsigned char>(!when_set),
                             static_cast<unsigned char>(when_set)));
    answer(refused);
  }
  bool install() {
    answer(SECCOMP_RET_ALLOW);
    const sock_fprog program{static_cast<unsigned short>(code_.size()), code_.data()};
    return architecture != 0 && prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
           prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
  }

private:
  void load(std::size_t offset) {
    code_.push_back(BPF_STMT(BPF_LD | BPF_W | BPF_ABS, static_cast<unsigned>(offset)));
  }
  void answer(unsigned with) {
    code_.push_back(BPF_STMT(BPF_RET | BPF_K, with));
  }
  std::vector<sock_filter> code_;
};

void limit(__rlimit_resource what, unsigned long value) {
  const rlimit bound{value, value};
  setrlimit(what, &bound);
}

} // namespace

bool confine(unsigned long cpu_seconds, unsigned long memory_bytes) {
  limit(RLIMIT_CPU, cpu_seconds);
  limit(RLIMIT_AS, memory_bytes);
  limit(RLIMIT_CORE, 0);
  constexpr unsigned writing = O_WRONLY | O_RDWR | O_CREAT | O_TRUNC;
  Filter filter;
  for (const long call : {SYS_execve, SYS_execveat, SYS_socket, SYS_ptrace, SYS_openat2, SYS_truncate, SYS_mkdirat,
                          SYS_unlinkat, SYS_renameat2, SYS_linkat, SYS_symlinkat, SYS_mknodat, SYS_fchmodat,
                          SYS_fchownat, SYS_mount, SYS_kill, SYS_io_uring_setup})
    filter.refuse(call);
#ifdef SYS_open // calls that newer architectures do not have
  for (const long call : {SYS_creat, SYS_mkdir, SYS_rmdir, SYS_unlink, SYS_rename, SYS_renameat, SYS_link, SYS_symlink,
                          SYS_mknod, SYS_chmod, SYS_chown, SYS_fork, SYS_vfork})
    filter.refuse(call);
  filter.refuse_bits(SYS_open, 1, writing);
#endif
  filter.refuse(SYS_clone3, unknown); // the C library then falls back on clone, whose flags can be seen
  filter.refuse_bits(SYS_clone, 0, CLONE_THREAD, false);
  filter.refuse_bits(SYS_openat, 2, writing);
  return filter.install();
}

} // namespace rimpact::meshes
