#include "meshes/sandbox.h"

#include <cerrno>
#include <fcntl.h>
#include <memory>
#include <sched.h>
#include <seccomp.h>
#include <sys/resource.h>

namespace rimpact::meshes {
namespace {

void limit(__rlimit_resource what, unsigned long value) {
  const rlimit bound{value, value};
  setrlimit(what, &bound);
}

/// A filter that lets every system call through but those that it refuses.
class Filter {
public:
  Filter() : context_(seccomp_init(SCMP_ACT_ALLOW), seccomp_release) {}
  /// A call that this machine does not have is refused already.
  void refuse(int call, int error = EPERM) {
    if (context_ && seccomp_rule_add(context_.get(), SCMP_ACT_ERRNO(error), call, 0) != 0) complete_ = false;
  }
  /// Where the bits `mask` of argument `index` (from 0) are `bits`.
  void refuse_bits(int call, unsigned index, unsigned mask, unsigned bits) {
    if (context_ && seccomp_rule_add(context_.get(), SCMP_ACT_ERRNO(EPERM), call, 1,
                                     SCMP_CMP(index, SCMP_CMP_MASKED_EQ, mask, bits)) != 0)
      complete_ = false;
  }
  bool install() const { return context_ && complete_ && seccomp_load(context_.get()) == 0; }

private:
  std::unique_ptr<void, void (*)(scmp_filter_ctx)> context_;
  bool complete_ = true;
};

} // namespace

bool confine(unsigned long cpu_seconds, unsigned long memory_bytes) {
  limit(RLIMIT_CPU, cpu_seconds);
  limit(RLIMIT_AS, memory_bytes);
  limit(RLIMIT_CORE, 0);
  Filter filter;
  for (const int call :
       {SCMP_SYS(execve),    SCMP_SYS(execveat),       SCMP_SYS(socket),   SCMP_SYS(ptrace),    SCMP_SYS(openat2),
        SCMP_SYS(truncate),  SCMP_SYS(mkdirat),        SCMP_SYS(unlinkat), SCMP_SYS(renameat2), SCMP_SYS(linkat),
        SCMP_SYS(symlinkat), SCMP_SYS(mknodat),        SCMP_SYS(fchmodat), SCMP_SYS(fchownat),  SCMP_SYS(mount),
        SCMP_SYS(kill),      SCMP_SYS(io_uring_setup), SCMP_SYS(creat),    SCMP_SYS(mkdir),     SCMP_SYS(rmdir),
        SCMP_SYS(unlink),    SCMP_SYS(rename),         SCMP_SYS(renameat), SCMP_SYS(link),      SCMP_SYS(symlink),
        SCMP_SYS(mknod),     SCMP_SYS(chmod),          SCMP_SYS(chown),    SCMP_SYS(fork),      SCMP_SYS(vfork)})
    filter.refuse(call);
  filter.refuse(SCMP_SYS(clone3), ENOSYS); // the C library then falls back on clone, whose flags can be seen
  filter.refuse_bits(SCMP_SYS(clone), 0, CLONE_THREAD, 0);
  for (const unsigned writing : {O_WRONLY, O_RDWR, O_CREAT, O_TRUNC}) {
    filter.refuse_bits(SCMP_SYS(open), 1, writing, writing);
    filter.refuse_bits(SCMP_SYS(openat), 2, writing, writing);
  }
  return filter.install();
}

} // namespace rimpact::meshes
